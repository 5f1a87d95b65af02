namespace Rabit.Uav.Simulation;

/// <summary>
/// Events of PX4 1.14 by their ids (component_information/events, autopilot component): those that the recorded flights
/// have of refusals, takeovers, failsafes, take-off and landing.
/// </summary>
internal enum Px4Event : uint
{
    ArmedBy = 26266355,
    DisarmedBy = 32794487,
    TakeoffDetected = 21054825,
    LandingDetected = 26622124,
    DisarmDeniedInAir = 24942533,
    LoadTooHigh = 17836172,
    BatteryIsLow = 21826980,
    NoGroundConnection = 23579003,
    GroundStationLost = 27571288,
    GroundRegained = 31011876,
    ManualControlLost = 22400324,
    ManualControlRegained = 17490621,
    StickOverride = 18523838,
    TookOverInFailsafe = 17738815,
    FenceViolation = 29908441,
    PositionError = 23730088,
    GnssStopped = 31476391,
    TransitionDenied = 29684317,
    ShutdownFailed = 22624381,
    FailsafeWarning = 25334767,
    FailsafeLowBattery = 28993875,
    FailsafeCriticalBatteryWarning = 19252160,
    FailsafeEmergencyBatteryWarning = 16828543,
    FailsafeHold = 30481910,
    Failsafe = 26528394,
    FailsafeGenericHold = 21279712,
    FailsafeGeneric = 31382480,
    ReturnActivated = 18121339,
    ReturnLandsAtHome = 27934633,
    ReturnClimbs = 25988105,
    ReturnFlies = 32911184,
    ReturnDescends = 28905952,
    ReturnLands = 16962474,
}
