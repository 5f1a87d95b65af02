namespace Rabit.Mavlink;

/// <summary>In which of its two messages a command may go out.</summary>
public enum MavlinkCommandForms
{
    /// <summary>COMMAND_LONG; COMMAND_INT where the vehicle wants that.</summary>
    LongThenInt,

    /// <summary>COMMAND_INT; COMMAND_LONG, which loses the frame of the place, where the vehicle wants that.</summary>
    IntThenLong,

    /// <summary>COMMAND_LONG and nothing else.</summary>
    LongOnly,

    /// <summary>COMMAND_INT and nothing else: right where a vehicle that guessed the frame of an altitude would do harm.</summary>
    IntOnly,
}
