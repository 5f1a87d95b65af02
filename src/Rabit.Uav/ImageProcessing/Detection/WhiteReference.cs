using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// How bright white is in a picture: as the brightest thing in it that may be white. What is clearly darker in the same
/// light is grey: a slab of concrete, a stone. Where nothing white is in the picture, nothing is known.
/// </summary>
internal sealed class WhiteReference
{
    // Natural logarithms of light: how much darker a white panel may be than another one, and how sure that is.
    private const double MaxDarker = 0.12;
    private const double DarkerSigma = 0.08;

    // What is less like white than that is no reference: a lamp, the sun in a window.
    private const double MaxCost = PatchCandidates.MaxCost + 5;

    // Ground with less than that part of the light of the picture's ground lies in the shade, and what is there too.
    private const double ShadeLight = 0.35;

    private double _brightest;
    private double _groundLight;

    /// <summary>Begins a picture.</summary>
    /// <param name="level">The brightness of its ground.</param>
    public void Clear(int level) => (_brightest, _groundLight) = (0, LinearLight.Of(level));

    /// <summary>Notes what may be white.</summary>
    public void Add(in PatchShape shape, double cost)
    {
        if (cost <= MaxCost)
            _brightest = Math.Max(_brightest, LightOf(shape));
    }

    /// <summary>How much too dark something white is, in squared deviations.</summary>
    public double DarknessOf(in PatchShape shape)
    {
        double ground = LightOf(shape.GroundRed, shape.GroundGreen, shape.GroundBlue);
        if (ground < ShadeLight * _groundLight)
            return 0;
        double darker = Math.Log(_brightest / LightOf(shape));
        double off = Math.Max(0, darker - MaxDarker) / DarkerSigma;
        return off * off;
    }

    private static double LightOf(in PatchShape shape) => LightOf(shape.Red, shape.Green, shape.Blue);

    private static double LightOf(double red, double green, double blue)
        => (LinearLight.Of(red) + (2 * LinearLight.Of(green)) + LinearLight.Of(blue)) / 4;
}
