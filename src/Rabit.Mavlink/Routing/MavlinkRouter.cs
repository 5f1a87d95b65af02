using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Routing;

namespace Rabit.Mavlink;

/// <summary>
/// The routing rules of MAVLink (guide, "Routing", "Routing in detail"), without any I/O: it learns which component is
/// on which link and returns where a frame goes. It never changes a frame. One difference from the guide: a frame
/// addressed to a component of our system that was not seen on any link is not ours; the guide would have every
/// component act on it. One thread at a time; allocates nothing after it was made.
/// </summary>
/// <example>
/// <code>
/// var router = new MavlinkRouter(systemId: 1, componentId: 191);
/// router.SetLink(0, MavlinkLinkRules.Live);
/// router.SetLink(1, MavlinkLinkRules.Live);
///
/// // For every frame that arrives: Forward(router.Route(link, frame, info), frame, links, buffer)
///
/// static void Forward(MavlinkRoute route, in MavlinkFrame frame, Stream[] links, byte[] buffer)
/// {
///     for (int link = 0; link &lt; links.Length; link++)
///     {
///         if (route.GoesTo(link))
///             links[link].Write(buffer, 0, frame.WriteTo(buffer));
///     }
/// }
/// </code>
/// </example>
public sealed class MavlinkRouter
{
    /// <summary>How many links a router can have: the bits of a mask.</summary>
    public const int MaxLinks = 64;

    private const int DefaultSources = 1024;

    // Secrets and the state of one radio: never leave the link (MAVLink guide, "Message signing"; ArduPilot, "MAVLink
    // routing").
    private const int SetupSigning = 256;
    private const int RadioStatus = 109;
    private const int Radio = 166;

    private byte _systemId;
    private byte _componentId;

    // Components of our system beside that of our address; a gimbal that we drive, for example.
    private readonly bool[] _ownComponents = new bool[256];
    private readonly RouteTable _table;
    private ulong _links;
    private ulong _sendLinks;
    private ulong _forwardFromLinks;
    private ulong _radioStatusLinks;

    private long _delivered;
    private long _forwarded;
    private long _unknownTargets;
    private long _ourOwn;
    private long _linkLocal;
    private long _sourcesRefused;

    /// <summary>
    /// Makes a router without links and without an address of our own, until <see cref="SetOwnAddress"/> gives it one:
    /// only broadcasts are for us.
    /// </summary>
    public MavlinkRouter() => _table = new RouteTable(DefaultSources);

    /// <summary>Makes a router without links.</summary>
    /// <param name="systemId">Our system id, 1 to 255.</param>
    /// <param name="componentId">Our component id, 1 to 255.</param>
    /// <param name="maxSources">How many senders (system, component) it can remember, at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">An id is 0, or there is room for no sender.</exception>
    public MavlinkRouter(byte systemId, byte componentId, int maxSources = DefaultSources)
    {
        if (maxSources < 1)
            throw new ArgumentOutOfRangeException(
                nameof(maxSources), maxSources, "A router needs room for one sender at least.");
        SetOwnAddress(systemId, componentId);
        _table = new RouteTable(maxSources);
    }

    /// <summary>
    /// Whether frames whose id is not known, so that their address cannot be read, are forwarded as broadcasts.
    /// </summary>
    /// <value>The default is true, as the guide has it: the others may know them.</value>
    public bool ForwardsUnknownMessages { get; set; } = true;

    /// <summary>The decisions so far.</summary>
    public MavlinkRouterCounters Counters
        => new(_delivered, _forwarded, _unknownTargets, _ourOwn, _linkLocal, _sourcesRefused);

    /// <summary>How many senders (system, component) it remembers.</summary>
    public int Sources => _table.Count;

    /// <summary>
    /// Changes our own address, for example when the system id of the vehicle that carries us becomes known. What was
    /// learned stays.
    /// </summary>
    /// <param name="systemId">Our system id, 1 to 255.</param>
    /// <param name="componentId">Our component id, 1 to 255.</param>
    /// <exception cref="ArgumentOutOfRangeException">An id is 0.</exception>
    public void SetOwnAddress(byte systemId, byte componentId)
    {
        if (systemId == 0)
            throw new ArgumentOutOfRangeException(
                nameof(systemId), systemId, "0 means every system; ours is 1 to 255.");
        if (componentId == 0)
            throw new ArgumentOutOfRangeException(
                nameof(componentId), componentId, "0 means every component; ours is 1 to 255.");
        _systemId = systemId;
        _componentId = componentId;
    }

    /// <summary>
    /// Says to which links RADIO_STATUS and RADIO are forwarded: those with a ground station that shows the state of
    /// all radios. Never one with a vehicle: an autopilot would take it for the state of its own radio, and slow down.
    /// </summary>
    /// <param name="links">Bit n is link n; 0, as at first, for none.</param>
    public void SetRadioStatusLinks(ulong links) => _radioStatusLinks = links;

    /// <summary>
    /// Makes us another component of our system beside that of our own address: a payload or a gimbal that this
    /// computer drives. What is addressed to it is for us, and what comes in from it is an echo.
    /// </summary>
    /// <param name="componentId">Its component id, 1 to 255.</param>
    /// <exception cref="ArgumentOutOfRangeException">The id is 0.</exception>
    public void AddOwnComponent(byte componentId)
    {
        if (componentId == 0)
            throw new ArgumentOutOfRangeException(
                nameof(componentId), componentId, "0 means every component; ours is 1 to 255.");
        _ownComponents[componentId] = true;
    }

    /// <summary>Adds a link, or changes the rules of one.</summary>
    /// <param name="link">0 to 63, the caller's choice.</param>
    /// <param name="rules">What may be done with it.</param>
    /// <exception cref="ArgumentOutOfRangeException">No such link number.</exception>
    public void SetLink(int link, MavlinkLinkRules rules)
    {
        ulong bit = Bit(link);
        _links |= bit;
        _sendLinks = (rules & MavlinkLinkRules.Send) != 0 ? _sendLinks | bit : _sendLinks & ~bit;
        _forwardFromLinks = (rules & MavlinkLinkRules.ForwardFrom) != 0
            ? _forwardFromLinks | bit
            : _forwardFromLinks & ~bit;
    }

    /// <summary>Takes a link away and forgets who was seen on it.</summary>
    /// <param name="link">0 to 63; one that was never added does no harm.</param>
    /// <exception cref="ArgumentOutOfRangeException">No such link number.</exception>
    public void RemoveLink(int link)
    {
        ulong bit = Bit(link);
        _links &= ~bit;
        _sendLinks &= ~bit;
        _forwardFromLinks &= ~bit;
        _table.ForgetLinks(bit);
    }

    /// <summary>
    /// Forgets where a system was seen. <see cref="Route(int, in MavlinkFrame, in MavlinkFrameInfo)"/> does so for a
    /// component whose SYSTEM_TIME shows that it was started again, as the guide requires.
    /// </summary>
    /// <param name="systemId">The system.</param>
    public void ForgetSystem(byte systemId)
    {
        if (systemId != 0)
            _table.ForgetSystem(systemId);
    }

    /// <summary>The links on which a component was seen.</summary>
    /// <param name="systemId">Its system id.</param>
    /// <param name="componentId">Its component id; 0 for any component of the system.</param>
    /// <returns>Bit n is link n.</returns>
    public ulong LinksOf(byte systemId, byte componentId) =>
        componentId == 0 ? _table.LinksOf(systemId) : _table.LinksOf(systemId, componentId);

    /// <summary>Returns where a received frame goes, and learns from it.</summary>
    /// <param name="link">The link it was received on.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="info">What the reader found out about it.</param>
    /// <returns>Where it goes; never back to its link.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The link was not added.</exception>
    public MavlinkRoute Route(int link, in MavlinkFrame frame, in MavlinkFrameInfo info) =>
        Route(link, frame, info.Message, info.IsChecked);

    /// <summary>Returns where a received frame goes, and learns from it.</summary>
    /// <param name="link">The link it was received on.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="message">The description of its message.</param>
    /// <param name="isChecked">
    /// Whether its id is known and its checksum right. Only then is it learned from and its address read.
    /// </param>
    /// <returns>Where it goes; never back to its link.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The link was not added.</exception>
    public MavlinkRoute Route(int link, in MavlinkFrame frame, in MavlinkMessageInfo message, bool isChecked)
        => isChecked
            ? Route(link, frame, frame.TargetSystem(message), frame.TargetComponent(message), isChecked)
            : Route(link, frame, targetSystem: 0, targetComponent: 0, isChecked);

    /// <summary>Says where a frame goes that came in, and learns from it: where its address was read before.</summary>
    /// <param name="link">The link it came from.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="targetSystem">See <see cref="MavlinkFrame.TargetSystem"/>.</param>
    /// <param name="targetComponent">See <see cref="MavlinkFrame.TargetComponent"/>.</param>
    /// <param name="isChecked">
    /// Whether its id is known and its checksum right. Only then is it learned from and its address used.
    /// </param>
    /// <returns>Where it goes; never back to its link.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The link was not added.</exception>
    public MavlinkRoute Route(int link, in MavlinkFrame frame, byte targetSystem, byte targetComponent, bool isChecked)
    {
        ulong bit = Bit(link);
        if ((_links & bit) == 0)
            throw new ArgumentOutOfRangeException(nameof(link), link, "The link was not added: SetLink comes first.");
        if (_systemId != 0 && frame.SystemId == _systemId && IsOwnComponent(frame.ComponentId))
        {
            _ourOwn++;
            return new MavlinkRoute(MavlinkRouteReason.OurOwn, deliverLocally: false, 0);
        }

        if (isChecked)
        {
            CheckRestart(frame);
            Learn(frame, bit);
        }

        MavlinkRoute route = isChecked
            ? RouteByAddress(frame.MessageId, targetSystem, targetComponent)
            : RouteUnchecked(frame.MessageId);
        ulong allowed = (_forwardFromLinks & bit) != 0 ? _sendLinks & ~bit : 0;
        return Count(new MavlinkRoute(route.Reason, route.DeliverLocally, route.ForwardTo & allowed));
    }

    /// <summary>
    /// Learns from a received frame that is not routed where its sender is: from a copy, which came over another link.
    /// </summary>
    /// <param name="link">The link it was received on.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="isChecked">Whether its id is known and its checksum right; else nothing is learned.</param>
    /// <exception cref="ArgumentOutOfRangeException">No such link number.</exception>
    public void Learn(int link, in MavlinkFrame frame, bool isChecked)
    {
        ulong bit = Bit(link);
        bool isOurs = _systemId != 0 && frame.SystemId == _systemId && IsOwnComponent(frame.ComponentId);
        if (isChecked && !isOurs)
            Learn(frame, bit);
    }

    /// <summary>
    /// Returns the links that a frame of our own goes to: to all if it is a broadcast, else where its target was seen.
    /// SETUP_SIGNING, which carries the key, goes nowhere without a target.
    /// </summary>
    /// <param name="frame">The frame.</param>
    /// <param name="message">The description of its message.</param>
    /// <returns>
    /// Bit n is link n; 0 where the target was not seen on any link that may be sent to, which is counted.
    /// </returns>
    public ulong RouteOwn(in MavlinkFrame frame, in MavlinkMessageInfo message)
    {
        byte system = frame.TargetSystem(message);
        ulong links = system != 0 ? LinksTowards(system, frame.TargetComponent(message))
            : frame.MessageId == SetupSigning ? 0
            : ulong.MaxValue;
        links &= _sendLinks;
        if (links == 0 && system != 0)
            _unknownTargets++;
        return links;
    }

    private bool IsOwnComponent(byte component) => component == _componentId || _ownComponents[component];

    private MavlinkRoute RouteByAddress(int messageId, byte system, byte component)
    {
        bool isForUs = system == 0 || (system == _systemId && (component == 0 || IsOwnComponent(component)));
        if (IsLinkLocal(messageId))
            return new MavlinkRoute(MavlinkRouteReason.LinkLocal, isForUs, RadioLinks(messageId));
        if (system == 0)
            return new MavlinkRoute(MavlinkRouteReason.Broadcast, isForUs, ulong.MaxValue);
        if (isForUs && component != 0)
            return new MavlinkRoute(MavlinkRouteReason.ForUs, isForUs, 0);

        ulong links = LinksTowards(system, component);
        MavlinkRouteReason reason = isForUs ? MavlinkRouteReason.ForOurSystem
            : links != 0 ? MavlinkRouteReason.ForOthers
            : MavlinkRouteReason.UnknownTarget;
        return new MavlinkRoute(reason, isForUs, links);
    }

    private MavlinkRoute RouteUnchecked(int messageId) => IsLinkLocal(messageId)
        ? new MavlinkRoute(MavlinkRouteReason.LinkLocal, deliverLocally: false, RadioLinks(messageId))
        : new MavlinkRoute(
            MavlinkRouteReason.UnknownMessage, deliverLocally: false, ForwardsUnknownMessages ? ulong.MaxValue : 0);

    // Within our own system the component decides; another system sorts that out itself.
    private ulong LinksTowards(byte system, byte component)
        => LinksOf(system, system == _systemId ? component : (byte)0);

    private ulong RadioLinks(int messageId) => messageId is RadioStatus or Radio ? _radioStatusLinks : 0;

    // A component whose time since boot goes back was started again, perhaps on another link (guide, "Routing"). Each
    // component has a time of its own, a companion another one than its autopilot; frames that overtake each other set
    // it back by less than a second.
    private void CheckRestart(in MavlinkFrame frame)
    {
        if (frame.MessageId != SystemTime.MavlinkId || !frame.TryDecode(out SystemTime time))
            return;
        if (_table.IsRestarted(frame.SystemId, frame.ComponentId, time.TimeBootMs))
            _table.Forget(frame.SystemId, frame.ComponentId);
        _table.NoteBootTime(frame.SystemId, frame.ComponentId, time.TimeBootMs);
    }

    private static bool IsLinkLocal(int messageId) => messageId is SetupSigning or RadioStatus or Radio;

    // 0 is no component's address; frames of a sender that uses it are delivered, but it cannot be answered.
    private void Learn(in MavlinkFrame frame, ulong link)
    {
        if (frame.SystemId != 0 && frame.ComponentId != 0 && !_table.TryLearn(frame.SystemId, frame.ComponentId, link))
            _sourcesRefused++;
    }

    private MavlinkRoute Count(in MavlinkRoute route)
    {
        if (route.DeliverLocally)
            _delivered++;
        if (route.ForwardTo != 0)
            _forwarded++;
        if (route.Reason == MavlinkRouteReason.UnknownTarget)
            _unknownTargets++;
        if (route.Reason == MavlinkRouteReason.LinkLocal)
            _linkLocal++;
        return route;
    }

    private static ulong Bit(int link) => (uint)link < MaxLinks
        ? 1UL << link
        : throw new ArgumentOutOfRangeException(nameof(link), link, "Links are numbered 0 to 63.");
}
