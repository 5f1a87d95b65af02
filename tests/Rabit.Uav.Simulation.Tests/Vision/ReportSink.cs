using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>Takes reports and looks, in the place of Sensor Fusion and Mission Control.</summary>
internal sealed class ReportSink : RabitManager
{
    private readonly QueueReceiver<TargetReport> _reports;
    private readonly QueueReceiver<CameraLook> _looks;
    private readonly QueueReceiver<CameraLook> _searchedGround;

    public ReportSink()
        : base("sink")
    {
        _reports = Receive<TargetReport>(MessageNames.TargetReports);
        _looks = Receive<CameraLook>(MessageNames.Looks);
        _searchedGround = Receive<CameraLook>(MessageNames.SearchedGround);
    }

    public List<TargetReport> Reports { get; } = [];

    public List<CameraLook> Looks { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_reports.TryPop(out TargetReport report))
            Reports.Add(report);
        while (_looks.TryPop(out CameraLook look))
            Looks.Add(look);
        while (_searchedGround.TryPop(out _))
        {
        }
    }
}
