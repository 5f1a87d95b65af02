using Microsoft.CodeAnalysis;

namespace Rabit.Core.Analyzers;

/// <summary>The types of Rabit.Core that the rules are about, in one compilation.</summary>
internal sealed class KnownTypes
{
    private KnownTypes(INamedTypeSymbol manager, Compilation compilation)
    {
        Manager = manager;
        Workspace = compilation.GetTypeByMetadataName("Rabit.Core.RabitWorkspace");
        PushResult = compilation.GetTypeByMetadataName("Rabit.Core.PushResult");
        QueueSender = compilation.GetTypeByMetadataName("Rabit.Core.QueueSender`1");
        SelfCopying = compilation.GetTypeByMetadataName("Rabit.Core.ISelfCopying`1");
        TrustedImmutable = compilation.GetTypeByMetadataName("Rabit.Core.TrustedImmutableAttribute");
        HandedOver = compilation.GetTypeByMetadataName("Rabit.Core.HandedOverAttribute");
        BufferLease = compilation.GetTypeByMetadataName("Rabit.Core.BufferLease");
        Disposable = compilation.GetTypeByMetadataName("System.IDisposable");
    }

    public INamedTypeSymbol Manager { get; }

    public INamedTypeSymbol? Workspace { get; }

    public INamedTypeSymbol? PushResult { get; }

    public INamedTypeSymbol? QueueSender { get; }

    public INamedTypeSymbol? SelfCopying { get; }

    public INamedTypeSymbol? TrustedImmutable { get; }

    public INamedTypeSymbol? HandedOver { get; }

    public INamedTypeSymbol? BufferLease { get; }

    public INamedTypeSymbol? Disposable { get; }

    /// <returns>Null where the compilation does not use Rabit.Core.</returns>
    public static KnownTypes? Find(Compilation compilation)
        => compilation.GetTypeByMetadataName("Rabit.Core.RabitManager") is { } manager
            ? new KnownTypes(manager, compilation)
            : null;

    public bool IsManager(INamedTypeSymbol type)
    {
        for (INamedTypeSymbol? each = type.BaseType; each is not null; each = each.BaseType)
        {
            if (Is(each, Manager))
                return true;
        }

        return false;
    }

    /// <summary>Whether a method is, or overrides, one of the manager's.</summary>
    public bool IsManagersOwn(IMethodSymbol method, string name)
    {
        IMethodSymbol first = method;
        while (first.OverriddenMethod is { } overridden)
            first = overridden;
        return first.Name == name && Is(first.ContainingType, Manager);
    }

    public static bool Is(ITypeSymbol? type, INamedTypeSymbol? known)
        => known is not null && SymbolEqualityComparer.Default.Equals(type?.OriginalDefinition, known);
}
