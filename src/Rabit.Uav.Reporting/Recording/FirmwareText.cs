namespace Rabit.Uav.Reporting;

/// <summary>A version of flight software as AUTOPILOT_VERSION has it, for people.</summary>
internal static class FirmwareText
{
    /// <param name="version">Major, minor, patch and FIRMWARE_VERSION_TYPE, a byte each, from the highest.</param>
    public static string Of(uint version)
    {
        string number = $"{FlightText.Number(version >> 24)}.{FlightText.Number((version >> 16) & 255)}"
            + $".{FlightText.Number((version >> 8) & 255)}";
        return (version & 255) switch
        {
            255 => number,
            >= 192 => number + " release candidate",
            >= 128 => number + " beta",
            >= 64 => number + " alpha",
            _ => number + " development",
        };
    }
}
