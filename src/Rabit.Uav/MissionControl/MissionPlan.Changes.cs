namespace Rabit.Uav.MissionControl;

// What the operator can change in flight.
public sealed partial class MissionPlan
{
    internal MissionPlan WithSpeed(double metresPerSecond)
    {
        var changed = (MissionPlan)MemberwiseClone();
        changed._speed = metresPerSecond;
        return changed;
    }
}
