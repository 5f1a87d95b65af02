using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Time and energy of a plan: the climb, the legs that are not flown yet and the ways between them, the way home and
/// the landing. Revisits come on top: their number is not known.
/// </summary>
internal static class PlanEnergy
{
    private const double ClimbRate = 2;

    // Autopilots accelerate and brake with this, and settle before they turn.
    private const double Acceleration = 1.5;
    private const double TurnSeconds = 2;

    /// <param name="power">What the vehicle needs.</param>
    /// <param name="route">What is to be flown.</param>
    /// <param name="plan">The heights over the terrain.</param>
    /// <param name="mission">Speed and height.</param>
    /// <param name="wind">Assumed, from any side, m/s.</param>
    /// <param name="returnSpeed">m/s.</param>
    /// <param name="maxAirspeed">m/s.</param>
    /// <param name="returnStartSeconds">Until a return flies towards home.</param>
    public static (double Joules, double Seconds) Of(
        PowerModel power, SearchRoute route, FlightPlan plan, MissionPlan mission, double wind, double returnSpeed,
        double maxAirspeed, double returnStartSeconds)
    {
        double height = plan.HeightAboveHome(at: default, mission.HeightMetres);
        double climbing = height / ClimbRate;
        double joules = climbing * power.Watts(wind, ClimbRate);
        double seconds = climbing;
        double speed = mission.SpeedMetresPerSecond;

        // With and against the wind by turns.
        double watts = (power.Watts(speed + wind) + power.Watts(Math.Abs(speed - wind))) / 2;
        double turning = (speed / Acceleration) + TurnSeconds;
        PlanePoint at = default;
        for (int index = route.Flown; index < route.Count; index++)
        {
            LaneSegment leg = route.Legs[index];
            seconds += Fly(at.DistanceTo(leg.Start)) + Fly(leg.Length);
            Climb(leg.Start);
            Climb(leg.End);
        }

        PlanePoint headWind = at.Length > 0 ? (wind / at.Length) * at : default;
        (double home, double homeSeconds) = WayHome.Of(
            power, at, height, headWind, moreHeadWind: 0, returnSpeed, maxAirspeed,
            returnStartSeconds);
        return (joules + home, seconds + homeSeconds);

        // On the way: it takes no time, and sinking gives nothing back.
        void Climb(PlanePoint to)
        {
            (double climbed, height) = plan.ClimbBetween(at, to, mission.HeightMetres);
            joules += climbed / ClimbRate * (power.Watts(wind, ClimbRate) - power.Watts(wind));
            at = to;
        }

        double Fly(double metres)
        {
            double time = (metres / speed) + turning;
            joules += time * watts;
            return time;
        }
    }
}
