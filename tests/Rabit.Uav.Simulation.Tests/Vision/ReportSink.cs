using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>Takes reports and looks, in the place of Sensor Fusion and Mission Control.</summary>
internal sealed class ReportSink : RabitManager
{
    private readonly QueueReceiver<TargetReport> _reports;
    private readonly QueueReceiver<CameraObservation> _looks;
    private readonly QueueReceiver<CameraObservation> _searchedGround;

    public ReportSink()
        : base("sink")
    {
        _reports = Receive<TargetReport>(MessageNames.TargetReports);
        _looks = Receive<CameraObservation>(MessageNames.Looks);
        _searchedGround = Receive<CameraObservation>(MessageNames.SearchedGround);
    }

    public List<TargetReport> Reports { get; } = [];

    public List<CameraObservation> Looks { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_reports.TryPop(out TargetReport report))
            Reports.Add(report);
        while (_looks.TryPop(out CameraObservation look))
            Looks.Add(look);
        while (_searchedGround.TryPop(out _))
        {
        }
    }
}
