using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// Writes the dialect as a value: what a receiver must know of each message, and what a tool may ask.
/// </summary>
internal static class DialectEmitter
{
    public static GeneratedSource Emit(Dialect dialect, EmitOptions options, GeneratedTypeNames names)
    {
        bool isPackage = options.DialectProperty is not null;
        string className = isPackage ? "MavlinkDialect" : names.DialectClass;
        string property = options.DialectProperty ?? "Instance";
        List<DialectPart> parts = dialect.Parts
            .Where(part => isPackage && options.PartProperties.ContainsKey(part.File))
            .GroupBy(part => part.File, StringComparer.Ordinal).Select(same => same.First()).ToList();
        string basis = options.Existing is null ? "null" : "global::Rabit.Mavlink.MavlinkDialect.All";
        string create = $"MavlinkDialectData.Create({DefinitionDataWriter.Write(dialect, names, parts)}, {basis})";
        return CSharpEmitter.File($"{className}.{property}", isPackage ? "Rabit.Mavlink" : options.Namespace, writer =>
        {
            if (!isPackage)
                DocComment.Summary(writer, $"The dialect of {DocComment.Escape(dialect.Name)}.xml.");
            writer.Open(isPackage ? "public sealed partial class MavlinkDialect" : $"public static class {className}");
            Property(
                writer, property,
                $"The {dialect.Messages.Count} messages of {DocComment.Escape(dialect.Name)}.xml and what it includes.",
                create);
            foreach (DialectPart part in parts)
            {
                writer.Blank();
                int count = dialect.Messages.Count(
                    message => part.Files.Contains(message.File, StringComparer.Ordinal));
                Property(
                    writer, options.PartProperties[part.File],
                    $"The {count} messages of "
                        + $"{DocComment.Escape(part.File)}{(part.Files.Count > 1 ? " and what it includes" : "")}.",
                    $"{property}.Part(\"{part.File}\")");
            }

            writer.Close();
        });
    }

    private static void Property(SourceWriter writer, string name, string summary, string create)
    {
        DocComment.Summary(writer, summary + " Made at first use, the same object ever after.");
        writer.Open($"public static MavlinkDialect {name}");
        writer.Line($"get {{ return {name}Holder.Dialect; }}");
        writer.Close();
        writer.Blank();
        writer.Open($"private static class {name}Holder");
        writer.Line($"internal static readonly MavlinkDialect Dialect = {create};");
        writer.Close();
    }
}
