namespace Rabit.Uav.Messages;

/// <summary>What the exchange of messages between vehicles did since the start. A plain value.</summary>
public struct VehicleExchangeCounters
{
    /// <summary>Messages that were posted here.</summary>
    public long Posted { get; set; }

    /// <summary>Fragments that were sent, those that were sent again among them.</summary>
    public long FragmentsSent { get; set; }

    /// <summary>Fragments that were sent again.</summary>
    public long FragmentsResent { get; set; }

    /// <summary>Acknowledgements that were sent.</summary>
    public long AcknowledgementsSent { get; set; }

    /// <summary>Fragments, acknowledgements and announcements of others that were sent on.</summary>
    public long Relayed { get; set; }

    /// <summary>
    /// Copies of fragments, acknowledgements and announcements that did not go to a link that had no room, while they
    /// went to another; of messages that are not acknowledged, of what is sent on and of announcements only where the
    /// link had none for their whole lifetime, or until the next announcement.
    /// </summary>
    public long CopiesHeldBack { get; set; }

    /// <summary>Messages of others that were whole and handed on.</summary>
    public long Delivered { get; set; }

    /// <summary>Fragments that had come already.</summary>
    public long Duplicates { get; set; }

    /// <summary>Messages of types that are not known here, or of newer versions of them: ignored.</summary>
    public long NotUnderstood { get; set; }

    /// <summary>What came in and is no part of the exchange, or cannot be true.</summary>
    public long Malformed { get; set; }

    /// <summary>What came back from ourselves.</summary>
    public long Echoes { get; set; }

    /// <summary>
    /// Messages of others that were not whole when their lifetime ended, or for which there was no room.
    /// </summary>
    public long Incomplete { get; set; }

    /// <summary>Messages of ours whose lifetime ended: they were not sent, or not acknowledged by all.</summary>
    public long Expired { get; set; }
}
