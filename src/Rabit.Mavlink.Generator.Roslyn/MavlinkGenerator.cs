using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Text;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Reading;

namespace Rabit.Mavlink.Generator.Roslyn;

/// <summary>Generates messages and enums from the MAVLink definitions among the additional files of a project.</summary>
[Generator(LanguageNames.CSharp)]
public sealed class MavlinkGenerator : IIncrementalGenerator
{
    /// <inheritdoc/>
    public void Initialize(IncrementalGeneratorInitializationContext context)
    {
        IncrementalValueProvider<ImmutableArray<DialectInput?>> inputs = context.AdditionalTextsProvider
            .Combine(context.AnalyzerConfigOptionsProvider)
            .Select((pair, cancellation) => DialectInput.From(pair.Left, pair.Right, cancellation))
            .Where(input => input is not null)
            .Collect();
        context.RegisterSourceOutput(inputs, Generate);
    }

    private static void Generate(SourceProductionContext context, ImmutableArray<DialectInput?> inputs)
    {
        List<DialectFile> files = inputs.Select(input => input!.File).ToList();
        var reported = new HashSet<DialectFault>();
        foreach (DialectInput? root in inputs.Where(input => input!.IsRoot))
        {
            DialectReadResult result = DialectReader.Read(root!.File, files);
            // Two roots that include one bad file say so once.
            foreach (DialectFault fault in result.Faults.Where(reported.Add))
                context.ReportDiagnostic(DialectDiagnostics.From(fault));
            var options = new EmitOptions(root.Namespace ?? EmitOptions.DefaultNamespace(result.Dialect)) { DialectProperty = root.DialectProperty };
            foreach (GeneratedSource source in CSharpEmitter.Emit(result.Dialect, options))
                context.AddSource($"{options.Namespace}.{source.Name}", SourceText.From(source.Text, Encoding.UTF8));
        }
    }
}
