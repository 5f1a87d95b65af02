using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>
/// Says which MAVLink frames that come in go to a queue of <see cref="Messages.LinkFrame"/>, which one manager
/// receives. Frames come from every link, recorded logs included; on a signed link only those whose signature is
/// accepted. Only frames whose checksum was checked are delivered, which <see cref="CommunicationsOptions.Dialect"/>
/// decides. Several subscriptions may name the same message; each has a queue of its own. Communications never waits
/// for a queue: what does not fit is dropped by the rule of the queue, counted
/// (<see cref="CommunicationsManager.CountSubscriptions"/>) and logged. Immutable.
/// </summary>
/// <remarks>
/// What comes from one component only is filtered by the manager: <c>frame.Frame.SystemId</c> and
/// <c>frame.Frame.ComponentId</c> are the source.
/// </remarks>
/// <example>
/// A manager that receives a rangefinder, added to <see cref="UavOptions.OtherManagers"/>:
/// <code>
/// public sealed class RangefinderManager : RabitManager
/// {
///     private readonly MavlinkMessageReceiver&lt;DistanceSensor&gt; _ranges;
///
///     public RangefinderManager()
///         : base("rangefinder")
///         => _ranges = new(Receive&lt;LinkFrame&gt;("ranges", 64, QueueFullMode.DropOldest, wakeOnPush: true));
///
///     protected override void ExecuteUnitOfWork()
///     {
///         while (_ranges.TryPop(out DistanceSensor range, out _))
///             Log($"{range.CurrentDistance} cm");
///     }
/// }
///
/// options.OtherManagers = [new RangefinderManager()];
/// options.Subscriptions = [new MavlinkSubscription("ranges") { MessageIds = [DistanceSensor.MavlinkId] }];
/// </code>
/// </example>
public sealed class MavlinkSubscription
{
    /// <summary>Makes a subscription to all messages, until <see cref="MessageIds"/> says which.</summary>
    /// <param name="queue">
    /// The queue of <see cref="Messages.LinkFrame"/>; one manager declares that it receives it, best with
    /// <see cref="Core.QueueFullMode.DropOldest"/>. The check of the wiring names a queue without a receiver, or with
    /// two.
    /// </param>
    /// <exception cref="ArgumentException">The queue has no name.</exception>
    public MavlinkSubscription(string queue)
    {
        if (string.IsNullOrEmpty(queue))
            throw new ArgumentException("The queue of a MAVLink subscription has no name.", nameof(queue));
        Queue = queue;
    }

    /// <summary>The name of the queue.</summary>
    public string Queue { get; }

    /// <summary>The messages; none for all that are checked.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<int> MessageIds { get; init; } = [];

    /// <summary>
    /// The component of our system whose frames the queue gets: those that are addressed to it, to all components of
    /// our system, or to every system. Frames addressed to it alone are then for us and are not forwarded, so that a
    /// manager can be a gimbal or a payload, which sends its own heartbeats with a <see cref="MavlinkMessageSender"/>
    /// of the same id. Null for the component that this computer is (<see cref="UavOptions.ComponentId"/>): the queue
    /// gets what Autopilot Interface gets.
    /// </summary>
    /// <value>The default is null.</value>
    public byte? ComponentId { get; init; }
}
