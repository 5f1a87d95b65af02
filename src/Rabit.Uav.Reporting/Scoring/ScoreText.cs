namespace Rabit.Uav.Reporting;

/// <summary>Parts of the score in words.</summary>
internal static class ScoreText
{
    /// <summary>", 2 identity switches"; empty for none.</summary>
    public static string SwitchesOf(MissionScore score) => score.IdentitySwitches switch
    {
        0 => string.Empty,
        1 => ", 1 identity switch",
        _ => $", {FlightText.Number((long)score.IdentitySwitches)} identity switches",
    };
}
