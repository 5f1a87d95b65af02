using System.Globalization;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>Writes the dialect as a value: what a receiver must know of each message.</summary>
internal static class DialectEmitter
{
    public static GeneratedSource Emit(Dialect dialect, EmitOptions options, TypeNames names)
    {
        bool isPackage = options.DialectProperty is not null;
        string className = isPackage ? "MavlinkDialect" : PascalCase.Of(dialect.Name) + "Dialect";
        string property = options.DialectProperty ?? "Instance";
        return CSharpEmitter.File($"{className}.{property}", isPackage ? "Rabit.Mavlink" : options.Namespace, writer =>
        {
            if (!isPackage)
                DocComment.Summary(writer, $"The dialect of {DocComment.Escape(dialect.Name)}.xml.");
            writer.Open(isPackage ? "public sealed partial class MavlinkDialect" : $"public static class {className}");
            DocComment.Summary(writer, $"The {dialect.Messages.Count} messages of {DocComment.Escape(dialect.Name)}.xml and what it includes. Made at first use, the same object ever after.");
            writer.Open($"public static MavlinkDialect {property}");
            writer.Line($"get {{ return {property}Holder.Dialect; }}");
            writer.Close();
            writer.Blank();
            writer.Open($"private static class {property}Holder");
            writer.Open($"internal static readonly MavlinkDialect Dialect = new MavlinkDialect({Literal(dialect.Name)}, new MavlinkMessageInfo[]");
            foreach (MessageDefinition message in dialect.Messages)
                writer.Line(Info(message, names, isPackage ? options.Namespace + "." : ""));
            writer.Close(");");
            writer.Close();
            writer.Close();
        });
    }

    private static string Literal(string text) => "\"" + text.Replace("\\", "\\\\").Replace("\"", "\\\"") + "\"";

    private static string Info(MessageDefinition message, TypeNames names, string prefix) => string.Format(
        CultureInfo.InvariantCulture,
        "new MavlinkMessageInfo({0}{1}.MavlinkId, {0}{1}.MavlinkName, {0}{1}.MavlinkCrcExtra, {0}{1}.MavlinkMinimumLength, {0}{1}.MavlinkMaximumLength, {2}, {3}),",
        prefix.Length == 0 ? "" : "global::" + prefix, names.OfMessage(message), message.AddressOffset("target_system"), message.AddressOffset("target_component"));
}
