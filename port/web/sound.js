// SPDX-License-Identifier: MIT
//
// A tone for each important event, since the user looks at the sensor, not at the screen.

const TONES = { ready: [880], refused: [220], stop: [660, 880, 1100] }; // Hz
const LENGTH = 0.12; // seconds

let audio = null;

export function sound(name) {
    audio ??= new AudioContext();
    TONES[name].forEach((pitch, i) => {
        const tone = audio.createOscillator();
        const volume = audio.createGain();
        const begin = audio.currentTime + i * LENGTH;
        tone.frequency.value = pitch;
        volume.gain.setValueAtTime(0.2, begin);
        volume.gain.exponentialRampToValueAtTime(0.001, begin + LENGTH);
        tone.connect(volume).connect(audio.destination);
        tone.start(begin);
        tone.stop(begin + LENGTH);
    });
}
