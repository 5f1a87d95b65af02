using System.Linq;
using Rabit.Core;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Hosting;

/// <summary>Phase and health in one line, for the status of the service. One thread at a time.</summary>
internal sealed class VehicleText(RabitReactor reactor)
{
    private readonly MessageSubscriber<MissionStatus>? _mission
        = Published(reactor, MissionControlManager.ManagerName)
            ? reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission)
            : null;

    private readonly MessageSubscriber<HealthReport>? _health
        = Published(reactor, HealthManager.ManagerName)
            ? reactor.Workspace.Subscribe<HealthReport>(MessageNames.Health)
            : null;

    public string? Describe()
    {
        string? phase = null, health = null;
        if (_mission is not null)
        {
            _mission.Fetch();
            phase = "phase " + _mission.Value.Phase;
        }

        if (_health is not null)
        {
            _health.Fetch();
            HealthReport report = _health.Value;
            health = "health " + report.Level + (report.Reasons == HealthReasons.None ? "" : $" ({report.Reasons})");
        }

        string text = string.Join(", ", new[] { phase, health }.Where(t => t is not null));
        return text.Length > 0 ? text : null;
    }

    // One that took the place of ours may not publish what ours does.
    private static bool Published(RabitReactor reactor, string manager) => reactor.Any(m => m.Name == manager);
}
