using System;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// Who a frame is from: copies of frames that came already, over a loop or a second link, go no further; frames with our
// own address that we did not send, and such with that of our autopilot over another link, are reported.
public sealed partial class CommunicationsManager
{
    private readonly MavlinkDuplicateFilter _copies = new();
    private LinkPort? _linkOfAutopilot;

    private bool IsToBeRouted(LinkPort port, in MavlinkFrame frame)
    {
        // A log is no network: what it has twice was recorded twice.
        if (port.IsRecorded)
            return true;
        OwnAddress own = _ownAddress.Value;
        if (own.IsKnown && frame.SystemId == own.SystemId && frame.ComponentId == own.ComponentId
            && !_copies.Contains(frame, Now))
        {
            port.CountAddressConflict();
            return true;
        }

        if (_copies.IsDuplicate(frame, Now))
        {
            port.CountDuplicate();
            return false;
        }

        NoteLinkOfAutopilot(port, frame, own);
        return true;
    }

    private void NoteLinkOfAutopilot(LinkPort port, in MavlinkFrame frame, OwnAddress own)
    {
        ref readonly VehicleState vehicle = ref _vehicle.Value;
        bool isAutopilots = own.IsKnown && frame.SystemId == own.SystemId && frame.SystemId == vehicle.SystemId
            && frame.ComponentId == vehicle.ComponentId;
        if (!isAutopilots)
            return;
        if (_linkOfAutopilot is { } known && known != port && !known.IsSilent(Now - _options.SilentAfter))
            port.CountAddressConflict();
        else
            _linkOfAutopilot = port;
    }

    private void ReportAddresses(bool isEnd)
    {
        foreach (LinkPort port in _ports)
        {
            if (port.ConflictReport.IsDue(port.AddressConflicts, Now, isEnd))
                Log($"link {port.Number}: {port.AddressConflicts} frames so far have our own address and are not from "
                    + "us, or that of our autopilot, which comes in over another link: another component uses the same "
                    + "ids, or two links lead to the same vehicle");
        }
    }

    private ulong LinksToGroundStations()
    {
        ulong links = 0;
        foreach (LinkPort port in _ports)
        {
            if (port.IsToGroundStation(Now - _options.SilentAfter))
                links |= 1UL << port.Number;
        }

        return links;
    }

    private void ForwardRadioStatus()
    {
        if (_options.ForwardsRadioStatus)
            _router.SetRadioStatusLinks(LinksToGroundStations());
    }
}
