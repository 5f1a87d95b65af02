using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;

namespace Rabit.Core.Analyzers;

/// <summary>
/// What copies of a value would share and could change: the rules of the check of the wiring, as far as the compiler
/// sees the type. What it does not see, it does not report.
/// </summary>
internal sealed class SharedState(KnownTypes known, bool isQueue)
{
    private readonly HashSet<ITypeSymbol> _visited = new(SymbolEqualityComparer.Default);

    /// <returns>Why, with the path of the field; null where nothing is shared.</returns>
    public string? Find(ITypeSymbol type)
    {
        if (!isQueue && IsSelfCopying(type))
            return null;
        return Find(type, NameOf(type));
    }

    private string? Find(ITypeSymbol type, string path)
    {
        if (IsPlain(type) || !_visited.Add(type))
            return null;
        if (isQueue && IsHandedOver(type))
            return null;
        if (KnownTypes.Is(type, known.BufferLease))
            return $"{path} is a lease of a buffer, which has one owner at a time and travels by queue";
        if (type is IArrayTypeSymbol)
            return $"{path} is an array; use an immutable collection";
        if (type is not INamedTypeSymbol named)
            return null;
        if (IsTrusted(named))
            return FindInArguments(named, path);
        if (type.TypeKind == TypeKind.Delegate)
            return $"{path} is a delegate, which may reach anything";
        if (type.TypeKind == TypeKind.Interface || type.SpecialType == SpecialType.System_Object)
            return $"{path} is of type {NameOf(type)}, which may hold something mutable";
        if (type.TypeKind == TypeKind.Class && !type.IsSealed)
            return $"{path} is of class {NameOf(type)}, which is not sealed, so that a derived one may hold something "
                + "mutable";
        return FindInFields(named, path);
    }

    private string? FindInFields(INamedTypeSymbol type, string path)
    {
        bool isSource = type.Locations.Any(l => l.IsInSource);
        for (INamedTypeSymbol? declaring = type;
            declaring is { SpecialType: not (SpecialType.System_Object or SpecialType.System_ValueType) };
            declaring = declaring.BaseType)
        {
            foreach (IFieldSymbol field in declaring.GetMembers().OfType<IFieldSymbol>())
            {
                // Reference assemblies put stand-ins where private fields are.
                if (field.IsStatic || (!isSource && field.DeclaredAccessibility == Accessibility.Private))
                    continue;
                string fieldPath = $"{path}.{field.AssociatedSymbol?.Name ?? field.Name}";
                if (!type.IsValueType && !field.IsReadOnly)
                    return $"{fieldPath} can be changed, and {NameOf(type)} is a class, which copies would share";
                if (Find(field.Type, fieldPath) is { } why)
                    return why;
            }
        }

        return null;
    }

    private string? FindInArguments(INamedTypeSymbol type, string path)
    {
        foreach (ITypeSymbol argument in type.TypeArguments)
        {
            if (Find(argument, $"{path}<{NameOf(argument)}>") is { } why)
                return why;
        }

        return null;
    }

    private bool IsTrusted(INamedTypeSymbol type)
        => HasAttribute(type, known.TrustedImmutable)
            || (type.TypeKind != TypeKind.Interface && type.Name != "Builder"
                && type.ContainingNamespace?.ToDisplayString() is "System.Collections.Immutable"
                    or "System.Collections.Frozen");

    private bool IsHandedOver(ITypeSymbol type)
        => KnownTypes.Is(type, known.BufferLease) || KnownTypes.Is(type, known.Disposable)
            || type.AllInterfaces.Any(i => KnownTypes.Is(i, known.Disposable)) || HasAttribute(type, known.HandedOver);

    private bool IsSelfCopying(ITypeSymbol type)
        => type.IsReferenceType && type.AllInterfaces.Any(i => KnownTypes.Is(i, known.SelfCopying));

    private static bool HasAttribute(ITypeSymbol type, INamedTypeSymbol? attribute)
        => type.GetAttributes().Any(a => KnownTypes.Is(a.AttributeClass, attribute));

    private static bool IsPlain(ITypeSymbol type)
        => type.TypeKind is TypeKind.Enum or TypeKind.Error or TypeKind.TypeParameter
            || type.SpecialType is >= SpecialType.System_Boolean and <= SpecialType.System_String
                or SpecialType.System_IntPtr or SpecialType.System_UIntPtr or SpecialType.System_DateTime
            || (type.ContainingNamespace?.ToDisplayString() == "System"
                && type.Name is "Version" or "Uri" or "TimeZoneInfo" or "TimeSpan" or "DateTimeOffset" or "Guid");

    private static string NameOf(ITypeSymbol type)
        => type.ToDisplayString(SymbolDisplayFormat.MinimallyQualifiedFormat);
}
