using System;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Observer._1;

/// <summary>
/// A detector: pixels in, detections out. This one reports the centre of all strongly orange pixels; put yours here, a
/// neural network for example. Pose, geolocation and tracking stay as they are.
/// </summary>
public sealed class RaftDetector : ITargetDetector
{
    private const int MinPixels = 20;   // fewer are noise

    /// <summary>What it finds, and how large that is on the ground: other sizes are no target.</summary>
    public static TargetClass Raft { get; } = new("raft") { MinSideMetres = 0.5, MaxSideMetres = 2 };

    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        ReadOnlySpan<byte> pixels = input.Pixels.Span;   // red, green, blue; row by row from the top left
        (double count, double columns, double rows) = (0, 0, 0);
        for (int pixel = 0; pixel < input.Width * input.Height; pixel++)
        {
            if (!IsOrange(pixels.Slice(3 * pixel, 3)))
                continue;
            count++;
            columns += pixel % input.Width;
            rows += pixel / input.Width;
        }

        if (count < MinPixels)
            return DetectorResult.Found(0);   // or NotSearched("too dark"): then the ground does not count as searched
        double side = Math.Sqrt(count);
        detections[0] = new TargetDetection
        {
            Class = Raft.Name,
            CentreX = columns / count,
            CentreY = rows / count,
            WidthPixels = side,
            HeightPixels = side,
            Score = 0.9,
            Covariance = PixelCovariance.FromSigma(1),   // how uncertain the centre is, in pixels
        };
        return DetectorResult.Found(1);
    }

    private static bool IsOrange(ReadOnlySpan<byte> pixel) => pixel[0] >= 150 && pixel[1] <= 140 && pixel[2] <= 80;
}
