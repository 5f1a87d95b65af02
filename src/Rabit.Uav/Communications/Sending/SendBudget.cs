using System;
using System.Collections.Generic;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// How much Communications may send over one link, its own frames and forwarded ones together, and what goes first
/// where there is more: docs/managers/communications.md, "Sending under a budget".
/// </summary>
/// <example>
/// A radio of 57600 baud with error correction (SiK) as link 1:
/// <code>
/// var radio = new SendBudget { BytesPerSecond = 3600 };
/// options.Communications.SendBudgets = new Dictionary&lt;int, SendBudget&gt; { [1] = radio };
/// </code>
/// </example>
public sealed class SendBudget
{
    /// <summary>The least that makes sense: HEARTBEAT and a position each second.</summary>
    public const int MinBytesPerSecond = 100;

    /// <summary>Bytes per second on average, with headers, checksums and signatures.</summary>
    /// <value>The default is 3600: SiK at 64 kbit/s with error correction.</value>
    public int BytesPerSecond { get; set; } = 3600;

    /// <summary>
    /// How many bytes of heartbeats, emergencies and commands may go out at once beyond that. All others wait until
    /// nothing is ahead of them on the link, so that what is urgent never waits for more than one of them.
    /// </summary>
    /// <value>The default is 560: two of the longest frames.</value>
    public int BurstBytes { get; set; } = 2 * MavlinkFrame.MaxWireLength;

    /// <summary>
    /// Whether the rate follows the free part of the radio's buffer, <c>txbuf</c> of its RADIO_STATUS, by
    /// <see cref="RadioBufferLaw"/>.
    /// </summary>
    /// <value>The default is true; without RADIO_STATUS it changes nothing.</value>
    public bool FollowsRadioBuffer { get; set; } = true;

    /// <summary>How it follows that.</summary>
    /// <value>The default is <see cref="RadioBufferLaw.Px4"/>.</value>
    public RadioBufferLaw RadioBufferLaw { get; set; }

    /// <summary>
    /// Whether the rate follows how long frames take over the link and back, measured by PING once a second: it falls
    /// while they wait for more than 150 ms longer than in the best case of the last minutes. For links without
    /// RADIO_STATUS, where someone answers PING: PX4, QGroundControl, our Ground Control.
    /// </summary>
    /// <value>The default is false.</value>
    public bool FollowsRoundTripTime { get; set; }

    internal SendBudget Copy() => (SendBudget)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (BytesPerSecond < MinBytesPerSecond)
            yield return $"{nameof(BytesPerSecond)} is {BytesPerSecond}; it must be at least {MinBytesPerSecond}";
        if (RadioBufferLaw is not (RadioBufferLaw.Px4 or RadioBufferLaw.ArduPilot))
            yield return $"{nameof(RadioBufferLaw)} is {RadioBufferLaw:D}, which is no law";
        if (BurstBytes < MavlinkFrame.MaxWireLength)
            yield return $"{nameof(BurstBytes)} is {BurstBytes}; "
                + $"it must be at least the longest frame, {MavlinkFrame.MaxWireLength}";
    }
}
