using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>A target of ours as ArduPilot takes it. A plain value.</summary>
internal struct ReportedTarget(int latitudeDegE7, int longitudeDegE7, double altitudeAmslMetres)
{
    public int LatitudeDegE7 { get; } = latitudeDegE7;

    public int LongitudeDegE7 { get; } = longitudeDegE7;

    public double AltitudeAmslMetres { get; } = altitudeAmslMetres;

    /// <summary>Until when it may be reported, once a later one is in force; null while it may be in force.</summary>
    public TimeSpan? Expires { get; set; }
}
