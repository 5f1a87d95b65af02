using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Text;
using Rabit.Mavlink.Generator.Emitting;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Reading;

namespace Rabit.Mavlink.Generator.Roslyn;

/// <summary>
/// Generates messages and enums from the MAVLink definitions among the additional files of a project.
/// </summary>
[Generator(LanguageNames.CSharp)]
public sealed class MavlinkGenerator : IIncrementalGenerator
{
    /// <summary>The file that stands for everything the package has.</summary>
    private const string PackageRoot = "all.xml";

    private const string PackageNamespace = "Rabit.Mavlink.Messages";

    /// <inheritdoc/>
    public void Initialize(IncrementalGeneratorInitializationContext context)
    {
        IncrementalValueProvider<ImmutableArray<DialectInput?>> inputs = context.AdditionalTextsProvider
            .Combine(context.AnalyzerConfigOptionsProvider)
            .Select((pair, cancellation) => DialectInput.From(pair.Left, pair.Right, cancellation))
            .Where(input => input is not null)
            .Collect();
        IncrementalValueProvider<string?> rootNamespace = context.AnalyzerConfigOptionsProvider
            .Select(
                (provider, _) => provider.GlobalOptions.TryGetValue("build_property.RootNamespace", out string? name)
                    && name.Length != 0
                    ? name
                    : null);
        context.RegisterSourceOutput(
            inputs.Combine(rootNamespace), (output, pair) => Generate(output, pair.Left, pair.Right));
    }

    private static void Generate(
        SourceProductionContext context, ImmutableArray<DialectInput?> inputs, string? rootNamespace)
    {
        List<DialectInput> own = Of(inputs, DialectRole.Own);
        if (own.Count != 0)
            GenerateOwn(
                context, own, Of(inputs, DialectRole.Package),
                rootNamespace is null ? "Messages" : rootNamespace + ".Messages");
        List<DialectInput> source = Of(inputs, DialectRole.PackageSource);
        if (source.Count != 0)
            GeneratePackage(context, source);
    }

    private static void GenerateOwn(
        SourceProductionContext context, List<DialectInput> own, List<DialectInput> package, string defaultNamespace)
    {
        // A project's own files come first: an include finds the copy that a project keeps before that of the package.
        List<DialectFile> files = own.Concat(package).Select(input => input.File).ToList();
        List<DialectFile> packageFiles = package.Select(input => input.File).ToList();
        DialectFile? packageRoot = packageFiles.FirstOrDefault(file => IsPackageRoot(file.Path));
        Dialect? packageDialect = packageRoot is null ? null : DialectReader.Read(packageRoot, packageFiles).Dialect;
        ExistingTypes? existing = packageDialect is null ? null : new ExistingTypes(packageDialect, PackageNamespace);

        var reported = new HashSet<DialectFault>();
        var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        List<(string Namespace, DialectFile Root)> roots = DialectRoots.Of(own.Select(input => input.File).ToList())
            .Select(root => (own.First(input => input.Path == root.Path).Namespace ?? defaultNamespace, root)).ToList();
        foreach ((string chosen, DialectFile root) in roots)
        {
            DialectReadResult result = DialectReader.Read(root, files);
            // Two roots that include one bad file say so once.
            IEnumerable<DialectFault> faults = result.Faults;
            if (packageDialect is not null)
                faults = faults.Concat(CommandNumbers.Check(result.Dialect, packageDialect));
            foreach (DialectFault fault in faults.Where(reported.Add))
                context.ReportDiagnostic(DialectDiagnostics.From(fault));
            // Two dialects may both have their form of a type, so each gets a namespace of its own.
            bool isShared =
                roots.Count(other => string.Equals(other.Namespace, chosen, StringComparison.OrdinalIgnoreCase)) > 1;
            string @namespace = Unique(isShared ? $"{chosen}.{EmitOptions.NameOf(result.Dialect)}" : chosen, taken);
            Add(context, result.Dialect, new EmitOptions(@namespace) { Existing = existing });
        }
    }

    private static string Unique(string name, HashSet<string> taken)
    {
        string candidate = name;
        for (int number = 2; !taken.Add(candidate); number++)
            candidate = name + number;
        return candidate;
    }

    private static void GeneratePackage(SourceProductionContext context, List<DialectInput> source)
    {
        List<DialectFile> files = source.Select(input => input.File).ToList();
        DialectInput root = source.First(input => IsPackageRoot(input.Path));
        DialectReadResult result = DialectReader.Read(root.File, files);
        foreach (DialectFault fault in result.Faults)
            context.ReportDiagnostic(DialectDiagnostics.From(fault));
        Add(context, result.Dialect, new EmitOptions(PackageNamespace)
        {
            DialectProperty = root.DialectProperty,
            PartProperties = source.Where(input => input != root && input.DialectProperty is not null)
                .ToDictionary(
                    input => Path.GetFileName(input.Path), input => input.DialectProperty!, StringComparer.Ordinal),
        });
    }

    private static void Add(SourceProductionContext context, Dialect dialect, EmitOptions options)
    {
        foreach (GeneratedSource source in CSharpEmitter.Emit(dialect, options))
            context.AddSource($"{options.Namespace}.{source.Name}", SourceText.From(source.Text, Encoding.UTF8));
    }

    private static bool IsPackageRoot(string path)
        => string.Equals(Path.GetFileName(path), PackageRoot, StringComparison.OrdinalIgnoreCase);

    private static List<DialectInput> Of(ImmutableArray<DialectInput?> inputs, DialectRole role) =>
        inputs.Where(input => input!.Role == role).Select(input => input!).ToList();
}
