namespace Rabit.Uav.MissionControl;

/// <summary>How the motors stopped.</summary>
internal enum MotorStop
{
    /// <summary>They run, or never did.</summary>
    None,

    /// <summary>They have stopped just now, and what is reported does not say yet how.</summary>
    Undecided,

    /// <summary>On the ground, after a descent as slow as landings are.</summary>
    Landed,

    /// <summary>In the air, or the vehicle fell to the ground before.</summary>
    Fallen,

    /// <summary>Neither landed state nor height of that moment says where.</summary>
    Unknown,
}
