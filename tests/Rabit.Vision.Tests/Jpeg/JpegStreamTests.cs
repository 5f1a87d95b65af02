using System.Collections.Generic;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests.Jpeg;

public sealed class JpegStreamTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void TryFind_StreamInPieces_GivesEachPicture(int seed)
    {
        var numbers = new SeededNumbers(seed);
        byte[] thumbnail = Encoding.ASCII.GetBytes("Exif\0\0").Concat(JpegFiles.Read("grey.jpg")).ToArray();
        byte[][] pictures =
        [
            JpegFiles.Read("420.jpg"), JpegFiles.With(JpegFiles.Read("444.jpg"), 0xE1, thumbnail),
            JpegFiles.Read("422-restart-each.jpg"), JpegFiles.Read("420-separate.jpg"),
        ];
        byte[] stream = [1, 0xFF, 2, .. pictures.SelectMany(p => p.Concat(new byte[] { 0, 0xFF, 0xD8, 7 }))];
        var found = new List<byte[]>();
        int from = 0;
        for (int filled = 0; filled < stream.Length;)
        {
            filled = System.Math.Min(stream.Length, filled + 1 + numbers.Below(900));
            while (JpegStream.TryFind(stream, from, filled - from, out int start, out int length))
            {
                found.Add(stream.Skip(start).Take(length).ToArray());
                from = start + length;
            }
        }

        Assert.Equal(pictures.Length, found.Count);
        for (int at = 0; at < pictures.Length; at++)
            Assert.Equal(pictures[at], found[at]);
    }

    // Each of them is a begin whose segments hide those behind it, up to the picture: looked at one by one, that is as
    // much as the square of their number.
    [Fact]
    public void TryFind_BeginsWithinSegmentsOfOthers_TakesNoLongerThanTheirBytes()
    {
        byte[] whole = JpegFiles.Read("444.jpg");
        byte[] junk = [.. Enumerable.Repeat<byte[]>([0xFF, 0xD8, 0xFF, 0xE1, 0, 10], 200_000).SelectMany(b => b)];
        byte[] stream = [.. junk, .. new byte[12], .. whole];
        System.TimeSpan begin = ThreadTime.SoFar;

        Assert.True(JpegStream.TryFind(stream, 0, stream.Length, out int start, out int length));

        System.TimeSpan spent = ThreadTime.SoFar - begin;
        Assert.Equal((junk.Length + 12, whole.Length), (start, length));
        Assert.True(spent < System.TimeSpan.FromSeconds(5), $"{spent}");
    }

    [Fact]
    public void TryFind_CutPictureBeforeAWholeOne_GivesTheWholeOne()
    {
        byte[] cut = JpegFiles.Read("420.jpg");
        byte[] whole = JpegFiles.Read("444.jpg");
        byte[] stream = cut.Take(cut.Length - 200).Concat(whole).ToArray();

        Assert.True(JpegStream.TryFind(stream, 0, stream.Length, out int start, out int length));
        Assert.Equal((cut.Length - 200, whole.Length), (start, length));
    }
}
