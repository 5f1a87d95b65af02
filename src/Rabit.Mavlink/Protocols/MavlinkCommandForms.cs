namespace Rabit.Mavlink;

/// <summary>Which of the two command messages, COMMAND_LONG and COMMAND_INT, may carry a command.</summary>
public enum MavlinkCommandForms
{
    /// <summary>COMMAND_LONG; COMMAND_INT where the vehicle asks for it.</summary>
    LongThenInt,

    /// <summary>COMMAND_INT; COMMAND_LONG, which has no coordinate frame, where the vehicle asks for it.</summary>
    IntThenLong,

    /// <summary>COMMAND_LONG and nothing else.</summary>
    LongOnly,

    /// <summary>COMMAND_INT and nothing else: for vehicles that would take the altitude in another frame.</summary>
    IntOnly,
}
