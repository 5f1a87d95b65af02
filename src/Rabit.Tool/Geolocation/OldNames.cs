namespace Rabit.Tool.Geolocation;

/// <summary>Names that fields and columns had in an older form of the files.</summary>
internal static class OldNames
{
    /// <returns>The name that it has now; null for one that never was.</returns>
    public static string? NewNameOf(string name) => name switch
    {
        "time_s" => "timeSeconds",
        "lat_deg" => "latitudeDegrees",
        "lon_deg" => "longitudeDegrees",
        "alt_m" => "altitudeAmslMetres",
        "vn_mps" => "velocityNorthMetresPerSecond",
        "ve_mps" => "velocityEastMetresPerSecond",
        "vd_mps" => "velocityDownMetresPerSecond",
        "roll_deg" => "rollDegrees",
        "pitch_deg" => "pitchDegrees",
        "yaw_deg" => "yawDegrees",
        "ground_alt_m" => "groundAltitudeAmslMetres",
        _ => null,
    };
}
