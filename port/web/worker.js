// SPDX-License-Identifier: MIT
//
// The tool in a worker: one message starts it, and the answer is its output and the files that it wrote.
import { WASI, File, OpenFile, ConsoleStdout, PreopenDirectory, Inode, Fd, wasi } from "@bjorn3/browser_wasi_shim";

const CHUNK = 1 << 20; // bytes of a log that are read at a time

// A log is read in chunks: it may be larger than memory.
class OpenBlob extends Fd {
    constructor(inode, onProgress) {
        super();
        this.inode = inode;
        this.onProgress = onProgress;
        this.at = 0;
        this.begin = 0;
        this.chunk = new Uint8Array(0);
    }

    fd_fdstat_get() {
        return { ret: 0, fdstat: new wasi.Fdstat(wasi.FILETYPE_REGULAR_FILE, 0) };
    }

    fd_filestat_get() {
        return { ret: 0, filestat: this.inode.stat() };
    }

    fd_read(size) {
        if (this.at < this.begin || this.at >= this.begin + this.chunk.length) {
            const part = this.inode.blob.slice(this.at, this.at + CHUNK);
            this.chunk = new Uint8Array(new FileReaderSync().readAsArrayBuffer(part));
            this.begin = this.at;
            this.onProgress(this.at / this.inode.blob.size);
        }
        const from = this.at - this.begin;
        const data = this.chunk.slice(from, from + size);
        this.at += data.length;
        return { ret: 0, data };
    }

    fd_seek(offset, whence) {
        const base = whence === wasi.WHENCE_SET ? 0 : whence === wasi.WHENCE_CUR ? this.at : this.inode.blob.size;
        if (base + Number(offset) < 0) {
            return { ret: wasi.ERRNO_INVAL, offset: 0n };
        }
        this.at = base + Number(offset);
        return { ret: 0, offset: BigInt(this.at) };
    }

    fd_tell() {
        return { ret: 0, offset: BigInt(this.at) };
    }
}

// Standard output and error: pipes, since on a terminal the tool would draw its progress.
class PipedOutput extends ConsoleStdout {
    fd_fdstat_get() {
        const stat = super.fd_fdstat_get();
        stat.fdstat.fs_filetype = wasi.FILETYPE_SOCKET_STREAM;
        return stat;
    }
}

class BlobFile extends Inode {
    constructor(blob, onProgress) {
        super();
        this.blob = blob;
        this.onProgress = onProgress;
    }

    path_open() {
        return { ret: 0, fd_obj: new OpenBlob(this, this.onProgress) };
    }

    stat() {
        return new wasi.Filestat(this.ino, wasi.FILETYPE_REGULAR_FILE, BigInt(this.blob.size));
    }
}

// The tool first checks whether it may write here; in a page it may.
class Folder extends PreopenDirectory {
    fd_fdstat_get() {
        const stat = super.fd_fdstat_get();
        stat.fdstat.fs_rights_base = stat.fdstat.fs_rights_inherited = ~0n;
        return stat;
    }
}

// { module, args, files: [{ name, blob }] } -> { code, stdout, stderr, files: [{ name, bytes }] }
onmessage = ({ data: { module, args, files } }) => {
    const printed = [[], []];
    const capture = (which) => new PipedOutput((bytes) => printed[which].push(bytes.slice()));
    const onProgress = (share) => postMessage({ progress: share });
    const inputs = files.map(({ name, blob }) => [name, new BlobFile(blob, onProgress)]);
    const folder = new Folder(".", new Map(inputs));
    const shim = new WASI(["invcal", ...args], [], [new OpenFile(new File([])), capture(0), capture(1), folder], { debug: false });
    let code = 0;

    try {
        code = shim.start(new WebAssembly.Instance(module, { wasi_snapshot_preview1: shim.wasiImport }));
    } catch (error) {
        postMessage({ failed: String(error) });
        return;
    }
    const written = [];
    for (const [name, inode] of folder.dir.contents) {
        if (inode instanceof File) {
            written.push({ name, bytes: inode.data });
        }
    }
    const [stdout, stderr] = printed.map((parts) => new Blob(parts));
    postMessage({ code, stdout, stderr, files: written });
};
