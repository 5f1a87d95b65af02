using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Takes reports and looks, in the place of Sensor Fusion and Mission Control.</summary>
internal sealed class ObservationSink : RabitManager
{
    private readonly QueueReceiver<TargetReport> _reports;
    private readonly QueueReceiver<CameraObservation> _looks;
    private readonly QueueReceiver<CameraObservation> _searchedGround;

    public ObservationSink(int capacity)
        : base("sink")
    {
        _reports = Receive<TargetReport>(MessageNames.TargetReports, capacity);
        _looks = Receive<CameraObservation>(MessageNames.Looks, capacity);
        _searchedGround = Receive<CameraObservation>(MessageNames.SearchedGround, capacity);
    }

    public List<TargetReport> Reports { get; } = [];

    public List<CameraObservation> Looks { get; } = [];

    public List<CameraObservation> SearchedGround { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_reports.TryPop(out TargetReport report))
            Reports.Add(report);
        while (_looks.TryPop(out CameraObservation look))
            Looks.Add(look);
        while (_searchedGround.TryPop(out CameraObservation look))
            SearchedGround.Add(look);
    }
}
