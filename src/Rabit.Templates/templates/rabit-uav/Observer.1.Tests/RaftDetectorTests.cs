using System;
using Rabit.Uav.ImageProcessing;
using Xunit;

namespace Observer._1.Tests;

public sealed class RaftDetectorTests
{
    private const int Width = 64;
    private const int Height = 48;

    [Fact]
    public void Picture_WithARaft_IsLocatedAtItsCentre()
    {
        DetectorResult result = Detect(raftPixels: 10, out TargetDetection raft);

        Assert.Equal(1, result.Count);
        Assert.Equal(RaftDetector.Raft.Name, raft.Class);
        Assert.Equal(24.5, raft.CentreX, 6);   // the centre of the top left pixel is 0
        Assert.Equal(19.5, raft.CentreY, 6);
        Assert.Equal(10, raft.WidthPixels, 6);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(4)]   // noise
    public void Picture_WithoutARaft_HasNone(int raftPixels)
        => Assert.Equal(0, Detect(raftPixels, out _).Count);

    // Grey ground, and an orange square whose top left pixel is in column 20, row 15.
    private static DetectorResult Detect(int raftPixels, out TargetDetection first)
    {
        byte[] pixels = new byte[Width * Height * 3];
        Array.Fill(pixels, (byte)90);
        for (int row = 15; row < 15 + raftPixels; row++)
        {
            for (int column = 20; column < 20 + raftPixels; column++)
                new byte[] { 242, 112, 18 }.CopyTo(pixels, 3 * ((row * Width) + column));
        }

        Span<TargetDetection> detections = new TargetDetection[8];
        var input = new DetectorInput(
            pixels, Width, Height, [RaftDetector.Raft], PictureGroundScale.Uniform(metresPerPixel: 0.1));
        DetectorResult result = new RaftDetector().Detect(input, detections);
        first = detections[0];
        return result;
    }
}
