using System;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Jpeg;

public sealed class JpegHostileTests(ITestOutputHelper output)
{
    private static readonly string[] Files =
        ["grey.jpg", "444.jpg", "420.jpg", "410.jpg", "odd-sampling.jpg", "420-restarts.jpg", "420-separate.jpg"];

    private int _whole;
    private int _refused;

    [Fact]
    public void Decode_Mutations_EndInAPictureOrInAnError() => Mutate(seed: 11, count: 2_000);

    [Theory, Trait("Category", "Long")]
    [InlineData(1)]
    [InlineData(2)]
    public void Decode_ManyMutations_EndInAPictureOrInAnError(int seed) => Mutate(seed, count: 10_000);

    private void Mutate(int seed, int count)
    {
        var numbers = new SeededNumbers(seed);
        var decoder = new JpegDecoder(mayUseLibrary: false);
        byte[] pixels = [];
        for (int at = 0; at < count; at++)
        {
            byte[] file = Change(JpegFiles.Read(Files[at % Files.Length]), numbers);
            try
            {
                decoder.Open(file, 0, file.Length, $"seed {seed}, {at}");
                Assert.Null(RgbPicture.FindSizeFault(decoder.Width, decoder.Height));
                if (pixels.Length < decoder.Width * decoder.Height * 3)
                    pixels = new byte[decoder.Width * decoder.Height * 3];
                decoder.Decode(pixels);
                _whole++;
            }
            catch (PictureException e)
            {
                Assert.StartsWith($"seed {seed}, {at}: ", e.Message, StringComparison.Ordinal);
                _refused++;
            }
        }

        output.WriteLine($"seed {seed}: {_whole} decoded, {_refused} refused");
        Assert.True(_whole > count / 50 && _refused > count / 50);
    }

    // Bytes of any value, mostly in the header; cut, doubled and moved pieces.
    internal static byte[] Change(byte[] file, SeededNumbers numbers)
    {
        for (int left = 1 + numbers.Below(4); left > 0; left--)
        {
            int at = numbers.Below(numbers.Below(3) == 0 ? file.Length : Math.Min(700, file.Length));
            switch (numbers.Below(6))
            {
                case 0:
                    Array.Resize(ref file, Math.Max(at, 1));
                    break;
                case 1:
                    file[at] ^= (byte)(1 << numbers.Below(8));
                    break;
                case 2:
                    file[at] = 0xFF;
                    break;
                case 3:
                    int from = numbers.Below(file.Length);
                    int length = Math.Min(numbers.Below(64), file.Length - Math.Max(at, from));
                    Array.Copy(file, from, file, at, length);
                    break;
                default:
                    file[at] = (byte)numbers.Below(256);
                    break;
            }
        }

        return file;
    }
}
