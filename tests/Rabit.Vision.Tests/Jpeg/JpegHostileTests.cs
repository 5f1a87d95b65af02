using System;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Jpeg;

public sealed class JpegHostileTests(ITestOutputHelper output)
{
    private static readonly string[] Files =
        ["grey.jpg", "444.jpg", "420.jpg", "410.jpg", "odd-sampling.jpg", "420-restarts.jpg", "420-separate.jpg"];

    // What a stream may cost. A picture of these files takes some 2 ms, the largest that is read half a second. It is
    // this thread's processor time, so that a busy machine makes no difference.
    private const long MaxBytesToOpen = 64 * 1024;
    private static readonly TimeSpan MaxTime = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan MaxMeanTime = TimeSpan.FromMilliseconds(50);

    private byte[] _pixels = [];
    private int _whole;
    private int _refused;
    private long _mostBytes;
    private TimeSpan _longest;

    [Fact]
    public void Decode_Mutations_EndInAPictureOrInAnError() => Mutate(seed: 11, count: 2_000);

    [Theory, Trait("Category", "Long")]
    [InlineData(1)]
    [InlineData(2)]
    public void Decode_ManyMutations_EndInAPictureOrInAnError(int seed) => Mutate(seed, count: 10_000);

    // A size that would be read, in the header of a small file: it is refused before there is room for its pixels.
    [Theory]
    [InlineData("grey.jpg")]
    [InlineData("444.jpg")]
    [InlineData("420.jpg")]
    [InlineData("420-separate.jpg")]
    public void Decode_LargeSizeInASmallFile_IsRefusedBeforeThereIsRoomForIt(string name)
    {
        byte[] file = [.. JpegFiles.Read(name)];
        int frame = Enumerable.Range(2, file.Length - 10).First(i => file[i] == 0xFF && file[i + 1] is 0xC0 or 0xC1);
        (file[frame + 5], file[frame + 6], file[frame + 7], file[frame + 8]) = (0x0B, 0xE0, 0x3F, 0xF0);
        var decoder = new JpegDecoder(mayUseLibrary: false);
        TryDecode(decoder, file, name);

        long before = Allocated.SoFar;
        TryDecode(decoder, file, name);

        Assert.InRange(Allocated.SoFar - before, 0, MaxBytesToOpen);
        Assert.Equal((16_368, 3_040, 0), (decoder.Width, decoder.Height, _whole));
    }

    private void Mutate(int seed, int count)
    {
        var numbers = new SeededNumbers(seed);
        var decoder = new JpegDecoder(mayUseLibrary: false);
        TimeSpan begin = ThreadTime.SoFar;
        for (int at = 0; at < count; at++)
            TryDecode(decoder, Change(JpegFiles.Read(Files[at % Files.Length]), numbers), $"seed {seed}, {at}");
        TimeSpan mean = TimeSpan.FromTicks((ThreadTime.SoFar - begin).Ticks / count);

        output.WriteLine(
            $"seed {seed}: {_whole} decoded, {_refused} refused; {mean.TotalMilliseconds:0.000} ms each, the longest "
                + $"{_longest.TotalMilliseconds:0.0} ms, the most {_mostBytes} bytes");
        Assert.True(_whole > count / 50 && _refused > count / 50);
        Assert.InRange(mean, TimeSpan.Zero, MaxMeanTime);
    }

    // Whatever a stream says, it ends in a picture or in an error with its name, and within its limits.
    private void TryDecode(JpegDecoder decoder, byte[] file, string name)
    {
        TimeSpan begin = ThreadTime.SoFar;
        long bytes = Allocated.SoFar;
        long most = MaxBytesToOpen;
        try
        {
            decoder.Open(file, 0, file.Length, name);
            Assert.Null(RgbPicture.FindSizeFault(decoder.Width, decoder.Height));
            bytes += MakeRoom(decoder.Width * decoder.Height * 3);
            most += MaxBytesOf(decoder.Width, decoder.Height);
            decoder.Decode(_pixels);
            _whole++;
        }
        catch (PictureException e)
        {
            Assert.StartsWith(name + ": ", e.Message, StringComparison.Ordinal);
            _refused++;
        }

        bytes = Allocated.SoFar - bytes;
        TimeSpan spent = ThreadTime.SoFar - begin;
        Assert.True(bytes <= most, $"{name}: {bytes} bytes allocated, of {most}");
        Assert.True(spent < MaxTime, $"{name}: {spent}");
        _mostBytes = Math.Max(_mostBytes, bytes);
        _longest = spent > _longest ? spent : _longest;
    }

    // Samples of three components up to the end of their last unit, and some rows of each.
    private static long MaxBytesOf(long width, long height) => (3 * (width + 64) * (height + 64)) + (64 * (width + 64));

    // The caller's, not the decoder's: gives what it took.
    private long MakeRoom(int bytes)
    {
        long before = Allocated.SoFar;
        if (_pixels.Length < bytes)
            _pixels = new byte[bytes];
        return Allocated.SoFar - before;
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
