using System;

namespace Wheelchair;

/// <summary>How fast the chair may go, and how far it goes on when it brakes.</summary>
internal static class Braking
{
    public static readonly TimeSpan ControlPeriod = TimeSpan.FromMilliseconds(20);

    public const double TopSpeedMetresPerSecond = 1.5;

    /// <summary>For starting and for a joystick that is let go: gentle.</summary>
    public const double ComfortMetresPerSecondSquared = 0.8;

    /// <summary>For the safety stop: as hard as possible without throwing the driver out of the chair.</summary>
    public const double EmergencyMetresPerSecondSquared = 2;

    /// <summary>What the safety stop leaves between footrest and wall, at least.</summary>
    public const double ClearanceMetres = 0.3;

    /// <summary>From the moment of the decision: one more period at full speed, and then v²/2a.</summary>
    public static double StoppingDistanceMetres(double speedMetresPerSecond)
        => (speedMetresPerSecond * ControlPeriod.TotalSeconds)
            + (speedMetresPerSecond * speedMetresPerSecond / (2 * EmergencyMetresPerSecondSquared));
}
