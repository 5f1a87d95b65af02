namespace Rabit.Uav.Simulation;

/// <summary>The failsafes of ArduCopter whose action FS_OPTIONS may hold back.</summary>
internal enum FailsafeCause
{
    Radio,
    GroundStation,
    Battery,
}
