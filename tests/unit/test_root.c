/* SPDX-License-Identifier: MIT
 *
 * invcali_root has the bits of libm's square root.
 */
#include "core/vector.h"

#include "support.h"
#include "unity.h"

void setUp(void)
{
}
void tearDown(void)
{
}

static uint32_t bits_of(float x)
{
    uint32_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static void check(uint32_t bits)
{
    float x;

    memcpy(&x, &bits, sizeof x);
    const float root = invcali_root(x);
    const float libm = sqrtf(x);
    if (isnan(libm)) {
        TEST_ASSERT_TRUE(isnan(root));
    } else {
        TEST_ASSERT_EQUAL_HEX32(bits_of(libm), bits_of(root));
    }
}

static void test_the_ends_of_each_range(void)
{
    /* 0, subnormal, normal, 1, squares, infinity, NaN; and the negative ones */
    static const uint32_t at[] = {0,          0x400000,   0x800000,   0x1000000,
                                  0x3F800000, 0x40000000, 0x40800000, 0x41100000,
                                  0x7F7FFFFF, 0x7F800000, 0x7FC00000};

    for (unsigned i = 0; i < sizeof at / sizeof at[0]; i++) {
        for (uint32_t n = 0; n < 17; n++) {
            check(at[i] + n - 8);
            check((at[i] + n - 8) ^ UINT32_C(0x80000000));
        }
    }
}

static void test_random_bits(void)
{
    random_source source = random_start(1);

    for (int i = 0; i < 20000; i++) {
        check((uint32_t)random_uniform(&source, 0, 4294967296.0));
        check((uint32_t)random_uniform(&source, 0, 0x1000000)); /* half of them subnormal */
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_the_ends_of_each_range);
    RUN_TEST(test_random_bits);
    return UNITY_END();
}
