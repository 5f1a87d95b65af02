using System.Collections.Generic;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>What the metadata of a component say about one event. Immutable, safe from any thread.</summary>
public sealed class MavlinkEventDefinition
{
    internal MavlinkEventDefinition(
        uint id, string name, string group, string message, string description,
        IReadOnlyList<EventArgumentType> arguments)
    {
        (Id, Name, Group, Message, Description, Arguments) = (id, name, group, message, description, arguments);
    }

    /// <summary>Its number, with the component's in the high byte.</summary>
    public uint Id { get; }

    /// <summary>Its name with that of the component's events: <c>px4::commander_rc_override</c>.</summary>
    public string Name { get; }

    /// <summary><c>default</c>, <c>health</c>, <c>arming_check</c>, <c>calibration</c> or another.</summary>
    public string Group { get; }

    /// <summary>The short text as a template, with <c>{1}</c> for the first argument.</summary>
    public string Message { get; }

    /// <summary>The long text as a template; empty where there is none.</summary>
    public string Description { get; }

    internal IReadOnlyList<EventArgumentType> Arguments { get; }

    /// <summary>The short text of an event of this kind.</summary>
    /// <param name="happened">The event.</param>
    /// <returns>One line.</returns>
    public string MessageOf(in MavlinkEvent happened) => new EventTemplate(Arguments, happened.Message).Fill(Message);

    /// <summary>The long text of an event of this kind.</summary>
    /// <param name="happened">The event.</param>
    /// <returns>May have several lines; empty where there is none.</returns>
    public string DescriptionOf(in MavlinkEvent happened)
        => new EventTemplate(Arguments, happened.Message).Fill(Description);
}
