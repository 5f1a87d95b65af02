/* Makes the JPEG files of this folder and expected.txt: what libjpeg decodes of them (accurate integer method,
   triangle upsampling, the same as "djpeg -dct int -pnm").
   gcc -O2 -o make_jpegs make_jpegs.c -ljpeg -lm && ./make_jpegs          (libjpeg-turbo 2.1.5 of Debian 12)
   expected.txt: file, width, height, channels, FNV-1a hash of 64 bits over the samples. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <jpeglib.h>

struct Kind
{
    const char *name;
    int width, height, channels, quality;
    int sampling[6]; /* horizontal and vertical of each component */
    int restart;     /* units, 0 without */
    int optimize, progressive, arithmetic, rgb, separate;
};

static const struct Kind kinds[] = {
    {"grey", 61, 43, 1, 85, {1, 1}, 0, 0, 0, 0, 0, 0},
    {"grey-2x2", 40, 24, 1, 85, {2, 2}, 0, 0, 0, 0, 0, 0},
    {"444", 61, 43, 3, 90, {1, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"422", 61, 43, 3, 90, {2, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420", 61, 43, 3, 90, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"440", 61, 43, 3, 90, {1, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"411", 61, 43, 3, 90, {4, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"410", 61, 43, 3, 90, {4, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"odd-sampling", 61, 43, 3, 90, {2, 2, 1, 2, 2, 1}, 0, 0, 0, 0, 0, 0},
    {"420-wide", 200, 130, 3, 75, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"422-wide", 200, 70, 3, 75, {2, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"440-wide", 200, 70, 3, 75, {1, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420-best", 96, 64, 3, 100, {2, 2, 1, 1, 1, 1}, 0, 1, 0, 0, 0, 0},
    {"420-worst", 96, 64, 3, 1, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420-restarts", 93, 67, 3, 80, {2, 2, 1, 1, 1, 1}, 3, 0, 0, 0, 0, 0},
    {"422-restart-each", 61, 43, 3, 80, {2, 1, 1, 1, 1, 1}, 1, 1, 0, 0, 0, 0},
    {"420-separate", 61, 43, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 1},
    {"rgb", 61, 43, 3, 90, {1, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 1, 0},
    {"420-1x1", 1, 1, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420-3x5", 3, 5, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420-5x3", 5, 3, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420-4x5", 4, 5, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"422-4x2", 4, 2, 3, 80, {2, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"420-640x480", 640, 480, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
    {"progressive", 61, 43, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 1, 0, 0, 0},
    {"arithmetic", 61, 43, 3, 80, {2, 2, 1, 1, 1, 1}, 0, 0, 0, 1, 0, 0},
    {"cmyk", 24, 16, 4, 80, {1, 1, 1, 1, 1, 1}, 0, 0, 0, 0, 0, 0},
};

static uint32_t seed = 1;

static double uniform(void)
{
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216.0;
}

/* Slopes, stripes, noise and a bright square: all coefficients, and values that are cut at both ends. */
static void paint(unsigned char *to, int width, int height, int channels)
{
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            for (int c = 0; c < channels; c++)
            {
                double v = 128 + 90 * sin(0.11 * x * (c + 1) + 0.07 * y) + 40 * cos(0.9 * y - 0.31 * x * c);
                v += 30 * (uniform() - 0.5);
                if (x > width / 3 && x < width / 2 && y > height / 3 && y < height / 2)
                    v = c == 1 ? 20 : 255;
                to[(y * width + x) * channels + c] = v < 0 ? 0 : v > 255 ? 255 : (unsigned char)v;
            }
}

static void encode(const struct Kind *kind, const char *file)
{
    struct jpeg_compress_struct c;
    struct jpeg_error_mgr error;
    unsigned char *pixels = malloc(kind->width * kind->height * kind->channels);
    paint(pixels, kind->width, kind->height, kind->channels);
    FILE *out = fopen(file, "wb");
    c.err = jpeg_std_error(&error);
    jpeg_create_compress(&c);
    jpeg_stdio_dest(&c, out);
    c.image_width = kind->width;
    c.image_height = kind->height;
    c.input_components = kind->channels;
    c.in_color_space = kind->channels == 1 ? JCS_GRAYSCALE : kind->channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&c);
    if (kind->rgb)
        jpeg_set_colorspace(&c, JCS_RGB);
    jpeg_set_quality(&c, kind->quality, TRUE);
    c.dct_method = JDCT_ISLOW;
    c.optimize_coding = kind->optimize;
    c.arith_code = kind->arithmetic;
    c.restart_interval = kind->restart;
    for (int i = 0; i < 3 && i < kind->channels; i++)
    {
        c.comp_info[i].h_samp_factor = kind->sampling[2 * i];
        c.comp_info[i].v_samp_factor = kind->sampling[2 * i + 1];
    }
    if (kind->progressive)
        jpeg_simple_progression(&c);
    jpeg_scan_info scans[3];
    memset(scans, 0, sizeof scans);
    for (int i = 0; i < 3; i++)
    {
        scans[i].comps_in_scan = 1;
        scans[i].component_index[0] = i;
        scans[i].Se = 63;
    }
    if (kind->separate)
    {
        c.scan_info = scans;
        c.num_scans = 3;
    }
    jpeg_start_compress(&c, TRUE);
    while (c.next_scanline < c.image_height)
    {
        JSAMPROW row = pixels + c.next_scanline * kind->width * kind->channels;
        jpeg_write_scanlines(&c, &row, 1);
    }
    jpeg_finish_compress(&c);
    jpeg_destroy_compress(&c);
    fclose(out);
    free(pixels);
}

static void decode(const char *file, FILE *expected)
{
    struct jpeg_decompress_struct d;
    struct jpeg_error_mgr error;
    FILE *in = fopen(file, "rb");
    d.err = jpeg_std_error(&error);
    jpeg_create_decompress(&d);
    jpeg_stdio_src(&d, in);
    jpeg_read_header(&d, TRUE);
    d.dct_method = JDCT_ISLOW;
    d.do_fancy_upsampling = TRUE;
    jpeg_start_decompress(&d);
    uint64_t hash = 0xcbf29ce484222325ull;
    int length = d.output_width * d.output_components;
    unsigned char *row = malloc(length);
    while (d.output_scanline < d.output_height)
    {
        JSAMPROW rows = row;
        jpeg_read_scanlines(&d, &rows, 1);
        for (int i = 0; i < length; i++)
            hash = (hash ^ row[i]) * 0x100000001b3ull;
    }
    fprintf(expected, "%s %u %u %d %016llx\n", file, d.output_width, d.output_height, d.output_components,
        (unsigned long long)hash);
    jpeg_finish_decompress(&d);
    jpeg_destroy_decompress(&d);
    fclose(in);
    free(row);
}

int main(void)
{
    FILE *expected = fopen("expected.txt", "w");
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
    {
        char file[100];
        snprintf(file, sizeof file, "%s.jpg", kinds[i].name);
        encode(&kinds[i], file);
        decode(file, expected);
    }
    return fclose(expected);
}
