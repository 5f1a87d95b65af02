namespace Rabit.Uav.Simulation;

/// <summary>What can be made to go wrong.</summary>
public enum ScriptedFaultKind
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>The vehicle neither receives nor sends for the duration; it flies on.</summary>
    LinkSilent,

    /// <summary>The battery is suddenly as empty as the value says: what is left, 0 to 1.</summary>
    BatteryTo,

    /// <summary>The camera gives no pictures for the duration.</summary>
    CameraFreeze,

    /// <summary>
    /// The mean wind becomes the value, m/s, within a few seconds; after the duration what it was, or never where
    /// that is zero.
    /// </summary>
    WindTo,

    /// <summary>
    /// The pilot takes the flight mode with the number of the value or, where <see cref="ScriptedFault.Mode"/> is
    /// set, with that name: by a command of the ground station or by the switch of the remote control (
    /// <see cref="ScriptedFault.BySwitch"/>).
    /// </summary>
    PilotMode,

    /// <summary>
    /// A unit of work of a manager on board takes the duration: the first one that begins at the time or later. For
    /// <see cref="SimulatedWorld.AddHangsTo"/>.
    /// </summary>
    ManagerHangs,

    /// <summary>
    /// The ground station on the vehicle's second link (<see cref="SimulationOptions.HasGroundStation"/>) sends no
    /// heartbeats for the duration; to the end of the run where that is zero.
    /// </summary>
    GroundStationSilent,

    /// <summary>
    /// The remote control is not received for the duration; to the end of the run where that is zero.
    /// </summary>
    RcLost,

    /// <summary>The GPS has no fix for the duration; to the end of the run where that is zero.</summary>
    GpsLost,

    /// <summary>
    /// The GPS reports a position that is wrong by the value, metres to the north, for the duration; to the end of
    /// the run where that is zero.
    /// </summary>
    GpsGlitch,

    /// <summary>
    /// The autopilot measures the value as the voltage of its battery, V, for the duration; to the end of the run
    /// where that is zero. What is left in the battery stays as it is.
    /// </summary>
    BatteryVolts,

    /// <summary>
    /// The variances of the autopilot's estimator are above its limit for the duration; to the end of the run where
    /// that is zero.
    /// </summary>
    EkfFailsafe,

    /// <summary>
    /// The autopilot starts again. In the air the pilot holds the vehicle in the mode in which it starts, as after a
    /// reset by its watchdog, which keeps it armed; with the value 1 the motors stop, and it falls.
    /// </summary>
    Reboot,

    /// <summary>
    /// Another ground station, 255/190 on the vehicle's second link, commands the vehicle to
    /// <see cref="ScriptedFault.Place"/>: without a duration by one DO_REPOSITION that changes the mode, with one by
    /// position targets at 10 Hz. Where there is no place it sends targets of velocity zero, at least one.
    /// </summary>
    OtherCommander,

    /// <summary>
    /// A gust: the wind rises by the value, m/s, in its own direction, and falls again, within the duration.
    /// </summary>
    Gust,

    /// <summary>
    /// The companion computer (<see cref="SimulatedWorld.CreateComputer"/>) has the temperature of the value, degrees
    /// Celsius, for the duration; to the end of the run where that is zero.
    /// </summary>
    ComputerHot,

    /// <summary>
    /// The supply of the companion computer has too little voltage for the duration; to the end of the run where that
    /// is zero.
    /// </summary>
    ComputerUnderVoltage,

    /// <summary>
    /// The disk of the companion computer has the value free, bytes, for the duration; to the end of the run where that
    /// is zero.
    /// </summary>
    DiskLow,

    /// <summary>
    /// The pictures are black but for the noise, as under a lens cap, for the duration; to the end of the run where
    /// that is zero. So for all that follow.
    /// </summary>
    PicturesBlack,

    /// <summary>The pictures are white.</summary>
    PicturesWhite,

    /// <summary>
    /// Each picture is the last one before, with a number and a time of its own; with the value 1 and new noise.
    /// </summary>
    PicturesFrozen,

    /// <summary>
    /// The pictures are defocused: blurred by two boxes of the value to each side, pixels; 4 where that is zero.
    /// </summary>
    PicturesDefocused,

    /// <summary>
    /// Something dark is before the left of the lens; the value is the part of the picture, 0.5 where that is zero.
    /// </summary>
    PicturesCovered,

    /// <summary>
    /// The camera shakes: each picture is blurred along its columns over the value, pixels; 17 where that is zero.
    /// </summary>
    PicturesMotionBlurred,

    /// <summary>All pictures have the number of the first of them.</summary>
    PictureNumbersRepeat,

    /// <summary>The times of the pictures are later than the truth by the value, seconds.</summary>
    PictureTimesOff,

    /// <summary>The autopilot sends no attitude any more.</summary>
    AttitudeSilent,

    /// <summary>
    /// What is truly left in the battery is suddenly the value, 0 to 1, and the autopilot goes on counting its
    /// percentage as before: a cell has failed, or the battery never had what stands on it.
    /// </summary>
    BatteryTrueTo,

    /// <summary>
    /// The autopilot reports of its satellites that there is no fix, and flies on by its position, which is as good as
    /// before; for the duration, to the end of the run where that is zero.
    /// </summary>
    FixNotReported,

    /// <summary>
    /// The autopilot reports latitude and longitude 0 as its position, and flies by the right one; for the duration, to
    /// the end of the run where that is zero.
    /// </summary>
    PositionZero,

    /// <summary>
    /// The autopilot reports the position where it was when the fault began, with the velocity that it has, and flies
    /// by the right one; for the duration, to the end of the run where that is zero.
    /// </summary>
    PositionFrozen,

    /// <summary>
    /// The autopilot reports a position that is wrong by the value, metres to the north, and flies by the right one;
    /// for the duration, to the end of the run where that is zero.
    /// </summary>
    PositionJump,

    /// <summary>
    /// The autopilot reports the value as how far its estimate is off its measurements (1: they are rejected), of
    /// velocity, position and height, and does nothing about it; for the duration, to the end of the run where that is
    /// zero.
    /// </summary>
    EstimatorRatio,

    /// <summary>
    /// The autopilot does not know what is left in its battery, and reports -1; with the value 1 it does not know
    /// voltage and current either. For the duration, to the end of the run where that is zero.
    /// </summary>
    BatteryUnknown,

    /// <summary>
    /// The last position and the last attitude are sent once more, with a time since boot that is the value later,
    /// seconds (earlier where it is negative): a datagram that the network repeated, or a wrong time.
    /// </summary>
    TelemetryStale,

    /// <summary>The next answer to a TIMESYNC is wrong by the value, seconds.</summary>
    TimesyncWrong,

    /// <summary>
    /// What the vehicle sends takes the value longer, seconds, for the duration; to the end of the run where that is
    /// zero. What it receives does not.
    /// </summary>
    LinkDelayed,
}
