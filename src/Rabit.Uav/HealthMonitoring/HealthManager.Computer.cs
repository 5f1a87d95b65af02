using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The companion computer and the ground station.
public sealed partial class HealthManager
{
    private readonly BlockingReader<ComputerStatus>? _computer;
    private readonly HealthRuleSet<ComputerFacts> _computerRules = new(HealthRules.OfComputer);
    private readonly HealthRuleSet<GroundStationFacts> _groundStationRules = new(HealthRules.OfGroundStation);

    // The newest look is the only one of interest.
    private BlockingReader<ComputerStatus>? MakeComputer(IReaderSource<ComputerStatus>? source)
        => source is null
            ? null
            : AttachReader("computer", source, capacity: 1, QueueFullMode.DropOldest);

    private void EvaluateComputer(TimeSpan now)
    {
        if (_computer is null)
            return;
        while (_computer.TryPop(out ComputerStatus status))
            _next.Computer = status;
        _computerRules.Evaluate(
            new ComputerFacts(_next.Computer, now), subject: null, _options, now, _findings);
    }

    private void EvaluateGroundStation(TimeSpan now, bool isReplayOver)
    {
        TimeSpan? last = null;
        foreach (LinkWatch link in _links)
        {
            if (link.GroundStationTime is { } time && !(last >= time))
                last = time;
        }

        _groundStationRules.Evaluate(
            new GroundStationFacts(last, now, isReplayOver), subject: null, _options, now, _findings);
    }
}
