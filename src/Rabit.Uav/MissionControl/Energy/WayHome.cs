using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Time and energy from a place to the ground at home, in a wind. Pure functions of the power that the vehicle needs.
/// </summary>
internal static class WayHome
{
    // Slower over ground home is not reached before the wind changes.
    private const double MinGroundSpeed = 1;

    // The climb to the height of the return, and the wait over home.
    private const double FixedSeconds = 15;

    // Autopilots come down at 1.5 m/s, and at 0.5 m/s for the last 12 m.
    private const double SlowHeightMetres = 12;
    private const double SlowDescentRate = 0.5;
    private const double DescentRate = 1.5;

    /// <summary>
    /// Ground speed towards home: the commanded one, or where the wind allows less, PX4's formula (src/lib/rtl/
    /// rtl_time_estimator.cpp), Vg = sqrt(Va^2 - Wcross^2) + min(0, Walong), which takes nothing from a tail wind.
    /// </summary>
    /// <returns>m/s; 0 where home cannot be reached.</returns>
    public static double GroundSpeed(double commanded, double maxAirspeed, double along, double cross)
    {
        double forward = (maxAirspeed * maxAirspeed) - (cross * cross);
        double possible = forward > 0 ? Math.Sqrt(forward) + Math.Min(0, along) : 0;
        return possible >= MinGroundSpeed ? Math.Min(commanded, possible) : 0;
    }

    /// <summary>Energy and time home, with the landing.</summary>
    /// <param name="power">What the vehicle needs.</param>
    /// <param name="place">From home, metres.</param>
    /// <param name="height">Above home, metres.</param>
    /// <param name="wind">Velocity of the air, m/s.</param>
    /// <param name="moreHeadWind">What it may be stronger against the vehicle, m/s.</param>
    /// <param name="speed">Commanded ground speed, m/s.</param>
    /// <param name="maxAirspeed">m/s.</param>
    /// <param name="startSeconds">Until it flies towards home.</param>
    /// <returns>Infinite where home cannot be reached against the wind.</returns>
    public static (double Joules, double Seconds) Of(
        PowerModel power, PlanePoint place, double height, PlanePoint wind, double moreHeadWind, double speed,
        double maxAirspeed, double startSeconds)
    {
        (double joules, double seconds) = Landing(power, height, wind.Length + moreHeadWind);
        joules += startSeconds * power.Watts(wind.Length + moreHeadWind);
        seconds += startSeconds;
        double distance = place.Length;
        if (distance < 1)
            return (joules, seconds);
        PlanePoint towards = (-1 / distance) * place;
        double along = Math.Min(0, wind.Dot(towards)) - moreHeadWind;
        double cross = Math.Abs(wind.Cross(towards));
        double ground = GroundSpeed(speed, maxAirspeed, along, cross);
        if (!(ground > 0))
            return (double.PositiveInfinity, double.PositiveInfinity);
        double airspeed = Math.Sqrt(((ground - along) * (ground - along)) + (cross * cross));
        double way = distance / ground;
        return (joules + (way * power.Watts(airspeed)), seconds + way);
    }

    /// <summary>Energy and time to come down where it is.</summary>
    public static (double Joules, double Seconds) Landing(PowerModel power, double height, double windSpeed)
    {
        double slow = Math.Max(0, Math.Min(height, SlowHeightMetres));
        double seconds = FixedSeconds + (slow / SlowDescentRate) + (Math.Max(0, height - slow) / DescentRate);
        return (seconds * power.Watts(windSpeed), seconds);
    }
}
