using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Takes reports and looks, in the place of Sensor Fusion and Mission Control.</summary>
internal sealed class LookSink : RabitManager
{
    private readonly QueueReceiver<TargetReport> _reports;
    private readonly QueueReceiver<CameraLook> _looks;
    private readonly QueueReceiver<CameraLook> _searchedGround;

    public LookSink(int capacity)
        : base("sink")
    {
        _reports = Receive<TargetReport>(MessageNames.TargetReports, capacity);
        _looks = Receive<CameraLook>(MessageNames.Looks, capacity);
        _searchedGround = Receive<CameraLook>(MessageNames.SearchedGround, capacity);
    }

    public List<TargetReport> Reports { get; } = [];

    public List<CameraLook> Looks { get; } = [];

    public List<CameraLook> SearchedGround { get; } = [];

    protected override void ExecuteUnitOfWork()
    {
        while (_reports.TryPop(out TargetReport report))
            Reports.Add(report);
        while (_looks.TryPop(out CameraLook look))
            Looks.Add(look);
        while (_searchedGround.TryPop(out CameraLook look))
            SearchedGround.Add(look);
    }
}
