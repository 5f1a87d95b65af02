using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// What the operator commands. Before take-off hold, return and land give the mission up on the ground. After a takeover
// hold, return and continue also give control back to Mission Control, which takes the command of the vehicle first.
public sealed partial class MissionControlManager
{
    /// <inheritdoc/>
    public OperatorRequest Hold(string by, string reason) => Given(new(OperatorCommand.Hold, by, reason));

    /// <inheritdoc/>
    public OperatorRequest ReturnToLaunch(string by, string reason)
        => Given(new(OperatorCommand.Return, by, reason));

    /// <inheritdoc/>
    public OperatorRequest ContinueMission(string by, string reason)
        => Given(new(OperatorCommand.Continue, by, reason));

    /// <inheritdoc/>
    public OperatorRequest Land(string by, string reason) => Given(new(OperatorCommand.Land, by, reason));

    /// <inheritdoc/>
    public OperatorRequest SkipLane(string by, string reason) => Given(new(OperatorCommand.SkipLane, by, reason));

    /// <inheritdoc/>
    public OperatorRequest Revisit(int trackId, string by, string reason)
        => Given(new(OperatorCommand.Revisit, by, reason) { TrackId = trackId });

    /// <inheritdoc/>
    public OperatorRequest RevisitPlace(GeodeticPosition place, string by, string reason)
        => Given(new(OperatorCommand.RevisitPlace, by, reason) { Place = place });

    /// <inheritdoc/>
    public OperatorRequest Confirm(int trackId, string by, string reason)
        => Given(new(OperatorCommand.Confirm, by, reason) { TrackId = trackId });

    /// <inheritdoc/>
    public OperatorRequest Reject(int trackId, string by, string reason)
        => Given(new(OperatorCommand.Reject, by, reason) { TrackId = trackId });

    /// <inheritdoc/>
    public OperatorRequest ChangeSpeed(double metresPerSecond, string by, string reason)
        => Given(new(OperatorCommand.ChangeSpeed, by, reason) { SpeedMetresPerSecond = metresPerSecond });

    /// <inheritdoc/>
    public OperatorRequest ChangeParameter(MissionParameter parameter, double value, string by, string reason)
        => Given(new(OperatorCommand.ChangeParameter, by, reason) { Parameter = parameter, Value = value });

    /// <inheritdoc/>
    public OperatorRequest OfferArea(
        ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts, string by,
        string reason)
        => Given(new(OperatorCommand.OfferArea, by, reason) { Area = area, KeepOuts = keepOuts });

    /// <inheritdoc/>
    public MissionPlan? Mission => _flight?.Changes.Mission;

    /// <inheritdoc/>
    /// <exception cref="ArgumentNullException">There is none.</exception>
    public void Give(OperatorRequest request)
    {
        if (request is null)
            throw new ArgumentNullException(nameof(request));
        if (_flight is null)
        {
            request.Set(OperatorOutcome.Refused, "there is no mission");
            return;
        }

        _flight.Operator.Give(request);
        WakeUp();
    }

    private OperatorRequest Given(OperatorRequest request)
    {
        Give(request);
        return request;
    }
}
