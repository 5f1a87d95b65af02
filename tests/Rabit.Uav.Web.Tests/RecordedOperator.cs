using System.Collections.Concurrent;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Web.Tests;

/// <summary>Takes commands and does nothing.</summary>
internal sealed class RecordedOperator : IMissionOperator
{
    public ConcurrentQueue<OperatorRequest> Given { get; } = new();

    public MissionPlan? Mission => null;

    public void Give(OperatorRequest request) => Given.Enqueue(request);

    public OperatorRequest Hold(string by, string reason) => Take(OperatorCommand.Hold, by, reason);

    public OperatorRequest ReturnToLaunch(string by, string reason) => Take(OperatorCommand.Return, by, reason);

    public OperatorRequest ContinueMission(string by, string reason) => Take(OperatorCommand.Continue, by, reason);

    public OperatorRequest Land(string by, string reason) => Take(OperatorCommand.Land, by, reason);

    public OperatorRequest SkipLane(string by, string reason) => Take(OperatorCommand.SkipLane, by, reason);

    public OperatorRequest Revisit(int trackId, string by, string reason) => Take(OperatorCommand.Revisit, by, reason);

    public OperatorRequest RevisitPlace(GeodeticPosition place, string by, string reason)
        => Take(OperatorCommand.RevisitPlace, by, reason);

    public OperatorRequest Confirm(int trackId, string by, string reason) => Take(OperatorCommand.Confirm, by, reason);

    public OperatorRequest Reject(int trackId, string by, string reason) => Take(OperatorCommand.Reject, by, reason);

    public OperatorRequest ChangeSpeed(double metresPerSecond, string by, string reason)
        => Take(OperatorCommand.ChangeSpeed, by, reason);

    public OperatorRequest ChangeParameter(MissionParameter parameter, double value, string by, string reason)
        => Take(OperatorCommand.ChangeParameter, by, reason);

    public OperatorRequest OfferArea(
        ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts, string by,
        string reason)
        => Take(OperatorCommand.OfferArea, by, reason);

    private OperatorRequest Take(OperatorCommand command, string by, string reason)
    {
        var request = new OperatorRequest(command, by, reason);
        Give(request);
        return request;
    }
}
