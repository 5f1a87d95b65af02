using System;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// How unlike a form is to the shape that a class declares: the sum of squared deviations of its moments, each in its
/// standard deviations, as far as it lies outside what the shape may have.
/// </summary>
internal static class FormCost
{
    // One standard deviation of what is large, and what is added for what is small, by its area in pixels: the raster,
    // the blur, and ground at the edge; and by how much those make the fill of what is small larger. Measured in drawn
    // pictures from 6 pixels on.
    private const double FillSigma = 0.01;
    private const double FillSigmaOfPixel = 2;
    private const double FillGainOfPixel = 4;
    private const double MomentSigma = 0.02;
    private const double MomentSigmaOfPixel = 7;

    // Of a form of whole pixels, which has no parts of them at its edge.
    private const double MomentGainOfWhole = 2;

    /// <summary>The cost; 0 for a class that may have any shape.</summary>
    /// <param name="form">The moments of the form.</param>
    /// <param name="shape">What the class declares.</param>
    /// <param name="pixels">Its area.</param>
    /// <param name="isOfWholePixels">Whether its pixels count as a whole, at its edge too.</param>
    public static double Of(in FormMoments form, TargetShape shape, double pixels, bool isOfWholePixels)
    {
        if (shape == TargetShape.Any)
            return 0;
        (double minFill, double maxFill, double minFourth, double maxFourth) = shape switch
        {
            TargetShape.Rectangle => (0.97, 1.03, 0.52, 0.63),
            TargetShape.Circle => (1.0, 1.07, 0.0, 0.05),
            TargetShape.Cross => (0.62, 0.9, 0.72, 1.33),
            _ => (0.83, 0.9, 0.0, 0.05),
        };
        (double minThird, double maxThird) = shape == TargetShape.Triangle ? (0.75, 0.83) : (0, 0.04);
        double fill = isOfWholePixels ? form.Fill : form.Fill - (FillGainOfPixel / pixels);
        double momentSigma =
            (MomentSigma + (MomentSigmaOfPixel / pixels)) * (isOfWholePixels ? MomentGainOfWhole : 1);
        return Square(Outside(fill, minFill, maxFill) / (FillSigma + (FillSigmaOfPixel / pixels)))
            + Square(Outside(form.Third, minThird, maxThird) / momentSigma)
            + Square(Outside(form.Fourth, minFourth, maxFourth) / momentSigma);
    }

    private static double Outside(double value, double min, double max)
        => value < min ? min - value : value > max ? value - max : 0;

    private static double Square(double value) => value * value;
}
