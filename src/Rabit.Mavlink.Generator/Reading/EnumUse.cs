using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>A field whose values are of an enum, and where it is defined.</summary>
/// <param name="Message">The message that has the field.</param>
/// <param name="Field">The field; its enum is not null.</param>
/// <param name="Element">Its element.</param>
internal sealed record EnumUse(MessageDefinition Message, FieldDefinition Field, DefinitionElement Element);
