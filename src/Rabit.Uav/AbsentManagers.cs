using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav;

/// <summary>
/// What each of the six managers publishes, sends and receives, for the check of the wiring where it is left out.
/// <c>AbsentManagersTests</c> compares it with the wiring of the managers themselves.
/// </summary>
internal static class AbsentManagers
{
    public static IEnumerable<AbsentManager> Of(UavManagers without)
        => new[]
        {
            UavManagers.Communications, UavManagers.AutopilotInterface, UavManagers.ImageProcessing,
            UavManagers.SensorFusion, UavManagers.MissionControl, UavManagers.HealthMonitoring,
        }.Where(m => (without & m) != 0).Select(OfOne);

    private static AbsentManager OfOne(UavManagers manager)
    {
        string reason = $"was left out ({nameof(UavOptions)}.{nameof(UavOptions.Without)} has {manager})";
        return manager switch
        {
            UavManagers.Communications => new AbsentManager(CommunicationsManager.ManagerName, reason)
            {
                Publishes =
                [
                    .. Enumerable.Range(0, MavlinkRouter.MaxLinks).Select(MessageNames.LinkStatus),
                    MessageNames.VehicleMessages,
                ],
                Sends = [MessageNames.AutopilotFrames, MessageNames.TargetReports],
                Receives = [MessageNames.OutgoingFrames, MessageNames.OutgoingTargetReports],
            },
            UavManagers.AutopilotInterface => new AbsentManager(AutopilotManager.ManagerName, reason)
            {
                Publishes =
                [
                    MessageNames.VehicleState, MessageNames.OwnAddress, MessageNames.StatusTexts,
                    MessageNames.CommandAcknowledgements, MessageNames.AutopilotStatistics,
                    MessageNames.CommandAuthority, MessageNames.AutopilotParameters, MessageNames.Navigation,
                    MessageNames.AutopilotFence,
                ],
                Sends = [MessageNames.OutgoingFrames, MessageNames.Poses, MessageNames.VehicleCommandResults],
                Receives = [MessageNames.AutopilotFrames, MessageNames.VehicleCommands],
            },
            UavManagers.ImageProcessing => new AbsentManager(ImageProcessingManager.ManagerName, reason)
            {
                Publishes = [MessageNames.Imaging, MessageNames.LandingTarget],
                Sends = [MessageNames.CameraObservations, MessageNames.SearchedGround],
                Receives = [MessageNames.Poses],
            },
            UavManagers.SensorFusion => new AbsentManager(SensorFusionManager.ManagerName, reason)
            {
                Publishes = [MessageNames.Tracks],
                Sends = [MessageNames.OutgoingTargetReports],
                Receives =
                [
                    MessageNames.CameraObservations, MessageNames.TargetReports, MessageNames.TrackDecisions,
                ],
            },
            UavManagers.MissionControl => new AbsentManager(MissionControlManager.ManagerName, reason)
            {
                Publishes = [MessageNames.Mission, MessageNames.ImagingCommand],
                Sends = [MessageNames.VehicleCommands, MessageNames.TrackDecisions],
                Receives = [MessageNames.SearchedGround, MessageNames.VehicleCommandResults],
            },
            _ => new AbsentManager(HealthManager.ManagerName, reason)
            {
                Publishes = [MessageNames.Health, MessageNames.Preflight],
                Sends = [MessageNames.OutgoingFrames],
            },
        };
    }
}
