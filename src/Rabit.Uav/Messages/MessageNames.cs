using System.Globalization;

namespace Rabit.Uav.Messages;

/// <summary>The names under which the managers of a UAV meet: publish-subscribe messages and queues.</summary>
public static class MessageNames
{
    /// <summary>Message <see cref="Messages.VehicleState"/>, posted by Autopilot Interface.</summary>
    public const string VehicleState = "vehicle";

    /// <summary>Message <see cref="Messages.OwnAddress"/>, posted by Autopilot Interface.</summary>
    public const string OwnAddress = "own address";

    /// <summary>Message <see cref="RecentItems{T}"/> of <see cref="StatusText"/>, posted by Autopilot Interface.</summary>
    public const string StatusTexts = "status texts";

    /// <summary>Message <see cref="RecentItems{T}"/> of <see cref="CommandAcknowledgement"/>, posted by Autopilot Interface.</summary>
    public const string CommandAcknowledgements = "command acknowledgements";

    /// <summary>Message <see cref="Messages.HealthReport"/>, posted by Health Monitoring.</summary>
    public const string Health = "health";

    /// <summary>Queue of <see cref="LinkFrame"/>: what Communications hands to Autopilot Interface.</summary>
    public const string AutopilotFrames = "autopilot frames";

    /// <summary>Queue of <see cref="OutgoingFrame"/>: what any manager wants sent, for Communications.</summary>
    public const string OutgoingFrames = "outgoing frames";

    /// <summary>Message <see cref="Messages.LinkStatus"/> of one link, posted by Communications.</summary>
    /// <param name="link">Number of the link, from 0.</param>
    public static string LinkStatus(int link) => "link " + link.ToString(CultureInfo.InvariantCulture);
}
