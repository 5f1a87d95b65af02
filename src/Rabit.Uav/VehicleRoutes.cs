using System;
using System.Collections.Generic;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav;

/// <summary>What the managers of a vehicle say to those of other vehicles, by Communications.</summary>
internal static class VehicleRoutes
{
    /// <summary>Those of the library, by what the system is made of.</summary>
    public static IEnumerable<VehicleMessageRoute> Of(UavOptions options)
    {
        yield return new VehicleMessageRoute<TargetReport>(
            new TargetReportCodec(), MessageNames.OutgoingTargetReports, MessageNames.TargetReports)
        {
            Lifetime = TimeSpan.FromSeconds(5),
        };
        if (options.MissionControl.Group is not null && options.Has(UavManagers.MissionControl))
        {
            foreach (VehicleMessageRoute route in OfGroup())
                yield return route;
        }

        if (HaveTracks(options))
        {
            yield return new VehicleMessageRoute<TrackEstimate>(
                new TrackEstimateCodec(), MessageNames.OutgoingTrackEstimates, MessageNames.TrackEstimates)
            {
                Lifetime = TimeSpan.FromSeconds(5),   // sent every 10 s
            };
        }
    }

    /// <summary>Whether the states of tracks are among them.</summary>
    public static bool HaveTracks(UavOptions options)
        => (options.Fusion.SharesTracks || options.MissionControl.Group is not null)
            && options.Has(UavManagers.SensorFusion)
            && options.Has(UavManagers.Communications);

    // All are repeated, so that none needs to be acknowledged.
    private static VehicleMessageRoute[] OfGroup() =>
    [
        new VehicleMessageRoute<GroupReport>(
            new GroupReportCodec(), MessageNames.OutgoingGroupReports, MessageNames.GroupReports)
        {
            // By it vehicles keep apart: it does not wait for what is agreed on, of which there may be much.
            Class = VehicleMessageClass.Command,
            Lifetime = TimeSpan.FromSeconds(2),
        },
        new VehicleMessageRoute<LaneDivision>(
            new LaneDivisionCodec(), MessageNames.OutgoingLaneDivisions, MessageNames.LaneDivisions)
        {
            Lifetime = TimeSpan.FromSeconds(2),
        },
        new VehicleMessageRoute<LaneCoverage>(
            new LaneCoverageCodec(), MessageNames.OutgoingLaneCoverages, MessageNames.LaneCoverages)
        {
            Class = VehicleMessageClass.Bulk,
            Lifetime = TimeSpan.FromSeconds(20),
        },
        new VehicleMessageRoute<ValidationTask>(
            new ValidationTaskCodec(), MessageNames.OutgoingValidationTasks, MessageNames.ValidationTasks)
        {
            Lifetime = TimeSpan.FromSeconds(1),
        },
        new VehicleMessageRoute<ValidationBid>(
            new ValidationBidCodec(), MessageNames.OutgoingValidationBids, MessageNames.ValidationBids)
        {
            Lifetime = TimeSpan.FromSeconds(1),
        },
        new VehicleMessageRoute<FollowTask>(
            new FollowTaskCodec(), MessageNames.OutgoingFollowTasks, MessageNames.FollowTasks)
        {
            Lifetime = TimeSpan.FromSeconds(1),
        },
        new VehicleMessageRoute<FollowBid>(
            new FollowBidCodec(), MessageNames.OutgoingFollowBids, MessageNames.FollowBids)
        {
            Lifetime = TimeSpan.FromSeconds(1),
        },
    ];
}
