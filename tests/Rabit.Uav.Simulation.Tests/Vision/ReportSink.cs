using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>Takes observations, in the place of Sensor Fusion and Mission Control.</summary>
internal sealed class ReportSink : RabitManager
{
    private readonly QueueReceiver<CameraObservation> _observations;
    private readonly QueueReceiver<CameraObservation> _searchedGround;

    public ReportSink(int capacity = 1000)
        : base("sink")
    {
        _observations = Receive<CameraObservation>(MessageNames.CameraObservations, capacity);
        _searchedGround = Receive<CameraObservation>(MessageNames.SearchedGround, capacity);
    }

    public IReadOnlyList<TargetReport> Reports => Observations.SelectMany(o => o.Reports).ToList();

    public List<CameraObservation> Observations { get; } = [];

    public List<CameraObservation> SearchedGround { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_observations.TryPop(out CameraObservation observation))
            Observations.Add(observation);
        while (_searchedGround.TryPop(out CameraObservation observation))
            SearchedGround.Add(observation);
    }
}
