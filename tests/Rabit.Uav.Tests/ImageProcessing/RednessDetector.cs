using System;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// A detector that is as simple as one can be: columns with red pixels in them, side by side, are one target.
/// </summary>
internal sealed class RednessDetector : ITargetDetector
{
    private const int Redness = 80;
    private const int MinPixels = 30;

    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        bool isWanted = false;
        foreach (TargetClass one in input.Classes)
            isWanted |= one.Name == DefaultTargetClasses.Red;
        if (!isWanted)
            return DetectorResult.Found(0);

        (int count, int dropped) = (0, 0);
        Sums sums = default;
        for (int column = 0; column <= input.Width; column++)
        {
            int before = sums.Pixels;
            for (int row = 0; column < input.Width && row < input.Height; row++)
                sums.Add(input, column, row);
            if (sums.Pixels > before || sums.Pixels == 0)
                continue;
            if (sums.Pixels >= MinPixels && count < detections.Length)
                detections[count++] = sums.ToDetection();
            else if (sums.Pixels >= MinPixels)
                dropped++;
            sums = default;
        }

        return DetectorResult.Found(count, dropped);
    }

    private struct Sums
    {
        public int Pixels;
        private double _columns;
        private double _rows;

        public void Add(in DetectorInput input, int column, int row)
        {
            ReadOnlySpan<byte> pixel = input.Pixels.Span.Slice((row * input.StrideBytes) + (3 * column), 3);
            if (pixel[0] - Math.Max(pixel[1], pixel[2]) < Redness)
                return;
            Pixels++;
            _columns += column;
            _rows += row;
        }

        public readonly TargetDetection ToDetection() => new()
        {
            Class = DefaultTargetClasses.Red,
            CentreX = _columns / Pixels,
            CentreY = _rows / Pixels,
            WidthPixels = Math.Sqrt(Pixels),
            HeightPixels = Math.Sqrt(Pixels),
            Score = 0.9,
            Covariance = PixelCovariance.FromSigma(1),
        };
    }
}
