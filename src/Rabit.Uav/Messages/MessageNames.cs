using System.Globalization;

namespace Rabit.Uav.Messages;

/// <summary>The names under which the managers of a UAV meet: publish-subscribe messages and queues.</summary>
public static class MessageNames
{
    /// <summary>Message <see cref="Messages.VehicleState"/>, posted by Autopilot Interface.</summary>
    public const string VehicleState = "vehicle";

    /// <summary>Message <see cref="Messages.OwnAddress"/>, posted by Autopilot Interface.</summary>
    public const string OwnAddress = "own address";

    /// <summary>
    /// Message <see cref="RecentItems{T}"/> of <see cref="StatusText"/>, posted by Autopilot Interface.
    /// </summary>
    public const string StatusTexts = "status texts";

    /// <summary>
    /// Message <see cref="RecentItems{T}"/> of <see cref="CommandAcknowledgement"/>, posted by Autopilot Interface.
    /// </summary>
    public const string CommandAcknowledgements = "command acknowledgements";

    /// <summary>Message <see cref="Messages.AutopilotStatistics"/>, posted by Autopilot Interface.</summary>
    public const string AutopilotStatistics = "autopilot statistics";

    /// <summary>Message <see cref="Messages.HealthReport"/>, posted by Health Monitoring.</summary>
    public const string Health = "health";

    /// <summary>Queue of <see cref="LinkFrame"/>: what Communications hands to Autopilot Interface.</summary>
    public const string AutopilotFrames = "autopilot frames";

    /// <summary>Queue of <see cref="OutgoingFrame"/>: what any manager wants sent, for Communications.</summary>
    public const string OutgoingFrames = "outgoing frames";

    /// <summary>Message <see cref="Messages.CommandAuthority"/>, posted by Autopilot Interface.</summary>
    public const string CommandAuthority = "command authority";

    /// <summary>Message <see cref="Messages.AutopilotParameters"/>, posted by Autopilot Interface.</summary>
    public const string AutopilotParameters = "autopilot parameters";

    /// <summary>Message <see cref="Messages.AutopilotFence"/>, posted by Autopilot Interface.</summary>
    public const string AutopilotFence = "autopilot fence";

    /// <summary>Message <see cref="NavigationStatus"/>, posted by Autopilot Interface.</summary>
    public const string Navigation = "navigation";

    /// <summary>Message <see cref="PreflightReport"/>, posted by Health Monitoring.</summary>
    public const string Preflight = "preflight";

    /// <summary>Message <see cref="Messages.ImagingCommand"/>, posted by Mission Control.</summary>
    public const string ImagingCommand = "imaging command";

    /// <summary>Message <see cref="Messages.ImagingStatus"/>, posted by Image Processing.</summary>
    public const string Imaging = "imaging";

    /// <summary>
    /// Message <see cref="LandingTargetObservation"/>, posted by Image Processing where a landing marker is declared.
    /// </summary>
    public const string LandingTarget = "landing target";

    /// <summary>Message <see cref="TrackList"/>, posted by Sensor Fusion.</summary>
    public const string Tracks = "tracks";

    /// <summary>Message <see cref="MissionStatus"/>, posted by Mission Control.</summary>
    public const string Mission = "mission";

    /// <summary>
    /// Queue of <see cref="PoseSample"/>: every position and attitude, from Autopilot Interface to Image Processing.
    /// </summary>
    public const string Poses = "poses";

    /// <summary>Queue of <see cref="VehicleCommand"/>: from Mission Control to Autopilot Interface.</summary>
    public const string VehicleCommands = "vehicle commands";

    /// <summary>Queue of <see cref="VehicleCommandResult"/>: from Autopilot Interface to Mission Control.</summary>
    public const string VehicleCommandResults = "vehicle command results";

    /// <summary>
    /// Queue of <see cref="TrackDecision"/>: the operator's decisions, from Mission Control to Sensor Fusion.
    /// </summary>
    public const string TrackDecisions = "track decisions";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="TargetReport"/>: reports of other vehicles, from
    /// Communications to Sensor Fusion.
    /// </summary>
    public const string TargetReports = "target reports";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="TargetReport"/>: from Sensor Fusion to Communications, for
    /// other vehicles.
    /// </summary>
    public const string OutgoingTargetReports = "outgoing target reports";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="TrackEstimate"/>: tracks of other vehicles of a group, from
    /// Communications to Sensor Fusion.
    /// </summary>
    public const string TrackEstimates = "track estimates";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="TrackEstimate"/>: from Sensor Fusion of a vehicle in a group to
    /// Communications, for the others.
    /// </summary>
    public const string OutgoingTrackEstimates = "outgoing track estimates";

    /// <summary>
    /// Message <see cref="Messages.GroupStatus"/>, posted by Mission Control of a vehicle in a group.
    /// </summary>
    public const string Group = "group";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="GroupReport"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string GroupReports = "group reports";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="GroupReport"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingGroupReports = "outgoing group reports";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="LaneDivision"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string LaneDivisions = "lane divisions";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="LaneDivision"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingLaneDivisions = "outgoing lane divisions";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="LaneCoverage"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string LaneCoverages = "lane coverages";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="LaneCoverage"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingLaneCoverages = "outgoing lane coverages";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="ValidationTask"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string ValidationTasks = "validation tasks";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="ValidationTask"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingValidationTasks = "outgoing validation tasks";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="ValidationBid"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string ValidationBids = "validation bids";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="ValidationBid"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingValidationBids = "outgoing validation bids";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="FollowTask"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string FollowTasks = "follow tasks";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="FollowTask"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingFollowTasks = "outgoing follow tasks";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="FollowBid"/>: of other vehicles, from Communications to
    /// Mission Control.
    /// </summary>
    public const string FollowBids = "follow bids";

    /// <summary>
    /// Queue of <see cref="Envelope{T}"/> of <see cref="FollowBid"/>: from Mission Control to Communications.
    /// </summary>
    public const string OutgoingFollowBids = "outgoing follow bids";

    /// <summary>
    /// Queue of <see cref="CameraObservation"/>: searched pictures with their reports, from Image Processing to Sensor
    /// Fusion.
    /// </summary>
    public const string CameraObservations = "camera observations";

    /// <summary>
    /// Queue of <see cref="CameraObservation"/>: from Image Processing to Mission Control, for the coverage.
    /// </summary>
    public const string SearchedGround = "searched ground";

    /// <summary>
    /// Message <see cref="VehicleMessageStatus"/>, posted by Communications where there are routes of vehicle messages.
    /// </summary>
    public const string VehicleMessages = "vehicle messages";

    /// <summary>
    /// Message <see cref="RecordingStatus"/>, posted by Communications where the links are recorded.
    /// </summary>
    public const string Recording = "recording";

    /// <summary>Message <see cref="Messages.LinkStatus"/> of one link, posted by Communications.</summary>
    /// <param name="link">Number of the link, from 0.</param>
    public static string LinkStatus(int link) => "link " + link.ToString(CultureInfo.InvariantCulture);
}
