using System;

namespace Rabit.Uav.Simulation;

/// <summary>The standard atmosphere of ISO 2533 below 11 km.</summary>
internal static class StandardAtmosphere
{
    private const double StandardHectopascals = 1013.25;
    private const double ScaleMetres = 44330.77;
    private const double Exponent = 5.255880;

    /// <summary>Air pressure at an altitude above mean sea level, hectopascals.</summary>
    public static double PressureAt(double altitudeAmslMetres)
        => StandardHectopascals * Math.Pow(1 - (altitudeAmslMetres / ScaleMetres), Exponent);
}
