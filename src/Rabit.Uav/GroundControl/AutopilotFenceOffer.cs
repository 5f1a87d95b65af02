using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.GroundControl;

/// <summary>
/// A fence of the autopilot that others have changed is an area that is offered, as one that is uploaded to our
/// component; a fence that is cleared withdraws it.
/// </summary>
internal sealed class AutopilotFenceOffer(IMissionOperator mission, Action<string> announce)
{
    private const string By = "the autopilot's fence";

    private OperatorRequest? _offer;
    private int? _offeredAfter;
    private int _changes;

    /// <summary>Takes the fence as it is now.</summary>
    /// <param name="fence">The fence.</param>
    /// <param name="otherOffers">How many areas were offered otherwise: the last one counts.</param>
    public void Take(AutopilotFence fence, int otherOffers)
    {
        if (!fence.IsKnown || fence.Changes == _changes)
            return;
        _changes = fence.Changes;
        if (mission.Mission is not { } plan)
            return;
        if (fence.Items.IsEmpty)
        {
            if (_offeredAfter == otherOffers)
                mission.OfferArea([], [], By, "it was cleared");
            (_offeredAfter, _offer) = (null, null);
        }
        else if (FindArea(plan, fence, out ImmutableArray<GeodeticPosition> area,
            out ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts) is { } fault)
        {
            announce($"{By} was changed, and is not offered as an area: {fault}");
        }
        else
        {
            _offer = mission.OfferArea(area, keepOuts, By, "it was changed");
            _offeredAfter = otherOffers;
        }
    }

    /// <summary>Announces what Mission Control has answered.</summary>
    public void Update()
    {
        if (_offer is not { } offer || offer.Outcome == OperatorOutcome.InProgress)
            return;
        _offer = null;
        bool isOffered = offer.Outcome == OperatorOutcome.Accepted;
        if (!isOffered)
            _offeredAfter = null;
        announce($"{By} was changed: area {(isOffered ? "offered" : "refused")}: {offer.Answer}");
    }

    private static string? FindArea(
        MissionPlan plan, AutopilotFence fence, out ImmutableArray<GeodeticPosition> area,
        out ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts)
    {
        (area, keepOuts) = ([], []);
        foreach (MissionItemInt item in fence.Items)
        {
            if (FencePolygons.Check(item) != MavMissionResult.Accepted)
                return FormattableString.Invariant($"item {item.Seq} is no corner of a polygon in a global frame");
        }

        if (FencePolygons.TryRead(fence.Items.AsSpan(), out area, out keepOuts) is { } fault)
            return fault;
        area = plan.AreaWithin(area);
        return area.IsEmpty ? "there is no area in it, with a margin to it" : null;
    }
}
