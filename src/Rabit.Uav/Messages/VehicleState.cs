using System;
using Rabit.Mavlink.Messages;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// What the autopilot says of the vehicle: the latest of everything. Stamped with the time at which the newest part was
/// true; parts with a rate of their own carry their own times, by the clock of the run. A plain value.
/// </summary>
public struct VehicleState
{
    /// <summary>Whether heartbeats of the autopilot come in.</summary>
    public bool IsConnected { get; set; }

    /// <summary>When the last heartbeat came; only meaningful once <see cref="SystemId"/> is not 0.</summary>
    public TimeSpan LastHeartbeatTime { get; set; }

    /// <summary>MAVLink system id of the vehicle; 0 before the first heartbeat of an autopilot.</summary>
    public byte SystemId { get; set; }

    /// <summary>MAVLink component id of the autopilot.</summary>
    public byte ComponentId { get; set; }

    /// <summary>The autopilot's make: ArduPilot, PX4, ...</summary>
    public MavAutopilot Autopilot { get; set; }

    /// <summary>The kind of vehicle.</summary>
    public MavType VehicleType { get; set; }

    /// <summary>
    /// The flight mode by the autopilot's own name, for example <c>GUIDED</c> or <c>AUTO.LOITER</c>; null before the
    /// first heartbeat.
    /// </summary>
    public string? Mode { get; set; }

    /// <summary>The flight mode as the autopilot sends it.</summary>
    public uint CustomMode { get; set; }

    /// <summary>The mode flags as the autopilot sends them.</summary>
    public MavModeFlag BaseMode { get; set; }

    /// <summary>Whether the motors may turn.</summary>
    public bool IsArmed { get; set; }

    /// <summary>The autopilot's own view of its state.</summary>
    public MavState SystemStatus { get; set; }

    /// <summary>Whether it flies, as far as the autopilot reports.</summary>
    public MavLandedState LandedState { get; set; }

    /// <summary>When <see cref="LandedState"/> was last reported; null before the first.</summary>
    public TimeSpan? LandedStateTime { get; set; }

    /// <summary>When position and velocity were true; null before the first.</summary>
    public TimeSpan? PositionTime { get; set; }

    /// <summary>Where the vehicle is.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Height above the home position, metres, up positive.</summary>
    public double HeightAboveHomeMetres { get; set; }

    /// <summary>Velocity over ground, metres per second, north-east-down.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>When the autopilot's estimator last reported; null where it never did.</summary>
    public TimeSpan? EstimatorTime { get; set; }

    /// <summary>
    /// Which parts of its estimate the autopilot's estimator counts on: flags of ESTIMATOR_STATUS (PX4). Those of
    /// ArduPilot's EKF_STATUS_REPORT are converted: the same bits, GPS_GLITCHING is GpsGlitch, UNINITIALIZED is none.
    /// </summary>
    public EstimatorStatusFlags EstimatorFlags { get; set; }

    /// <summary>
    /// Whether the horizontal position is an estimate that the autopilot counts on: without satellites ArduPilot goes
    /// on reporting where it lost its position. True where no estimator reports.
    /// </summary>
    public readonly bool HasValidHorizontalPosition => EstimatorTime is null
        || (EstimatorFlags & (EstimatorStatusFlags.PosHorizAbs | EstimatorStatusFlags.ConstPosMode))
            == EstimatorStatusFlags.PosHorizAbs;

    /// <summary>When attitude and rates were true; null before the first.</summary>
    public TimeSpan? AttitudeTime { get; set; }

    /// <summary>Attitude of the body in the local north-east-down frame.</summary>
    public EulerAngles Attitude { get; set; }

    /// <summary>Angular velocity in the body frame.</summary>
    public BodyRates Rates { get; set; }

    /// <summary>When a gimbal of the vehicle last reported its attitude; null where none did.</summary>
    public TimeSpan? GimbalTime { get; set; }

    /// <summary>When the battery was measured; null before the first.</summary>
    public TimeSpan? BatteryTime { get; set; }

    /// <summary>Battery voltage, volts; NaN where the autopilot does not know it.</summary>
    public double BatteryVolts { get; set; }

    /// <summary>Battery current, amperes, discharge positive; NaN where the autopilot does not know it.</summary>
    public double BatteryAmperes { get; set; }

    /// <summary>What remains in the battery, 0 to 1; NaN where the autopilot does not know it.</summary>
    public double BatteryRemaining { get; set; }

    /// <summary>
    /// Charge drawn from the battery since the autopilot began to count, ampere hours; NaN where it does not know it.
    /// </summary>
    public double BatteryConsumedAmpereHours { get; set; }

    /// <summary>
    /// How many cells the battery has, where the autopilot reports their voltages one by one; 0 where it does not.
    /// </summary>
    public int BatteryCells { get; set; }

    /// <summary>What the autopilot says of the charge of the battery.</summary>
    public MavBatteryChargeState BatteryChargeState { get; set; }

    /// <summary>What the autopilot says is wrong with the battery.</summary>
    public MavBatteryFault BatteryFaults { get; set; }

    /// <summary>
    /// Whether the autopilot says that the battery, which it monitors, is not healthy: its failsafe, or a warning.
    /// </summary>
    public bool IsBatteryUnhealthy { get; set; }

    /// <summary>When the receiver last reported its fix; null before the first.</summary>
    public TimeSpan? GpsTime { get; set; }

    /// <summary>How good the satellite fix is.</summary>
    public GpsFixType GpsFix { get; set; }

    /// <summary>Satellites in view; 255 where the autopilot does not know it.</summary>
    public int Satellites { get; set; }

    /// <summary>
    /// The height above mean sea level that the satellite receiver reports by itself, metres, at <see cref="GpsTime"/>:
    /// that of <see cref="Position"/> is the estimator's, which mostly goes by the barometer. Null where the receiver
    /// has no fix in three dimensions, or reports a height that cannot be.
    /// </summary>
    public double? GnssAltitudeAmslMetres { get; set; }

    /// <summary>How uncertain that is by the receiver, metres; null where it does not know it.</summary>
    public double? GnssAltitudeSigmaMetres { get; set; }

    /// <summary>
    /// The autopilot's UTC from satellites, microseconds since 1970, true at <see cref="UtcTime"/>; 0 where it does not
    /// know it.
    /// </summary>
    public long GpsUtcMicroseconds { get; set; }

    /// <summary>When <see cref="GpsUtcMicroseconds"/> was true; null before the first.</summary>
    public TimeSpan? UtcTime { get; set; }

    /// <summary>When the autopilot last reported an estimate of the wind; null before the first.</summary>
    public TimeSpan? WindTime { get; set; }

    /// <summary>
    /// Velocity of the air over ground, metres per second, north-east-down, without its vertical part: where the wind
    /// blows to, not where it comes from. As the autopilot estimates it (ArduPilot WIND, PX4 WIND_COV); NaN before the
    /// first estimate. Old after some seconds: see <see cref="WindTime"/>.
    /// </summary>
    public NedVector WindVelocityNed { get; set; }

    /// <summary>Speed of <see cref="WindVelocityNed"/>, metres per second; NaN before the first estimate.</summary>
    public readonly double WindMetresPerSecond => WindVelocityNed.HorizontalLength;
}
