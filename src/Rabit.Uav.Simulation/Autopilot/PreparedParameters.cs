namespace Rabit.Uav.Simulation;

/// <summary>
/// The failsafe parameters of a vehicle that was prepared for a flight, so that it passes the pre-flight checklist; all
/// others are the autopilot's defaults.
/// </summary>
internal static class PreparedParameters
{
    // 3.3 V for each of three cells, some 5 % of the charge under load: the autopilot's failsafe is for a computer that
    // has failed, and acts after those of the mission.
    private const float LowVolts = 9.9f;

    private static readonly (string Name, float Value)[] Ardupilot =
        [("FS_GCS_ENABLE", 1), ("BATT_LOW_VOLT", LowVolts), ("BATT_FS_LOW_ACT", 2)];

    // Return where the set-points stop and where the battery is critical; sticks interrupt OFFBOARD (bit 1).
    private static readonly (string Name, float Value)[] Px4 =
        [("COM_OBL_RC_ACT", 3), ("COM_LOW_BAT_ACT", 3), ("COM_RC_OVERRIDE", 3)];

    public static void ApplyTo(IVehicleAutopilot autopilot, SimulatedAutopilot make)
    {
        foreach ((string name, float value) in make == SimulatedAutopilot.Px4 ? Px4 : Ardupilot)
            autopilot.SetParameter(name, value);
    }
}
