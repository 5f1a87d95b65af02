using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.Linq;
using System.Reflection;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>
/// Refuses a message type that would let two managers share something that one of them can change (contract 2.5): its
/// copies must be independent all the way down. Of the type of a queue it says the same, but for what is handed over
/// with the value.
/// </summary>
internal static class MessageTypeCheck
{
    private static readonly HashSet<string> TrustedTypes = new(StringComparer.Ordinal)
    {
        "System.String", "System.Version", "System.Uri", "System.TimeZoneInfo",
    };

    /// <summary>
    /// Why the type cannot be a message, with the path of the field that is to blame; null when it can.
    /// </summary>
    /// <param name="type">The type of the message.</param>
    /// <param name="copiesItself">
    /// Whether it is a class that copies itself: what it holds is its own matter then.
    /// </param>
    /// <param name="trusted">Types that the user vouches for.</param>
    public static string? FindFault(Type type, bool copiesItself = false, IReadOnlyCollection<Type>? trusted = null)
    {
        string name = TypeNames.Of(type);
        if (!copiesItself)
            return FindFault(type, name, [], trusted ?? []);
        return type.IsSealed
            ? null
            : $"{name} copies itself but is not sealed: of a derived one a post would lose what it adds.";
    }

    /// <summary>
    /// How sender and receiver of a queue could share something that one of them can change; null where they cannot.
    /// </summary>
    /// <param name="type">The type of the queue.</param>
    /// <param name="trusted">Types that the user vouches for.</param>
    public static string? FindFaultInQueue(Type type, IReadOnlyCollection<Type> trusted)
        => FindFault(type, TypeNames.Of(type), [], trusted, IsHandedOver);

    // Who disposes it owns it, and the queue disposes what it drops.
    private static bool IsHandedOver(Type type)
        => typeof(IDisposable).IsAssignableFrom(type) || type.IsDefined(typeof(HandedOverAttribute), inherit: false);

    private static string? FindFault(
        Type type, string path, HashSet<Type> visited, IReadOnlyCollection<Type> trusted,
        Func<Type, bool>? isExempt = null)
    {
        if (type.IsPrimitive || type.IsEnum || TrustedTypes.Contains(type.FullName ?? string.Empty)
            || !visited.Add(type) || isExempt?.Invoke(type) == true)
            return null;
        if (type == typeof(BufferLease))
            return $"{path} is a {nameof(BufferLease)}: a buffer has one owner at a time, and travels by queue.";
        if (type.IsPointer)
            return $"{path} is a pointer, which copies would share.";
        if (trusted.Contains(type))
            return null;

        // Trust in a generic type says nothing of what it is made of.
        if (IsImmutableCollection(type) || IsVouchedFor(type, trusted))
            return FindFaultInArguments(type, path, visited, trusted, isExempt);
        if (type.IsArray)
            return $"{path} is an array ({TypeNames.Of(type)}), which copies would share; use an immutable collection.";
        if (typeof(Delegate).IsAssignableFrom(type))
            return $"{path} is a delegate ({TypeNames.Of(type)}), which may reach anything.";
        if (type.IsInterface || type == typeof(object))
            return $"{path} is of type {TypeNames.Of(type)}, which may hold something mutable.";
        if (!type.IsValueType && !type.IsSealed)
            return $"{path} is of class {TypeNames.Of(type)}, which is not sealed: "
                + "a derived one may hold something mutable.";
        return FindFaultInFields(type, path, visited, trusted, isExempt);
    }

    [UnconditionalSuppressMessage("Trimming", "IL2070",
        Justification = "A field that trimming removed holds nothing that could be shared.")]
    [UnconditionalSuppressMessage("Trimming", "IL2075",
        Justification = "A field that trimming removed holds nothing that could be shared.")]
    private static string? FindFaultInFields(
        Type type, string path, HashSet<Type> visited, IReadOnlyCollection<Type> trusted, Func<Type, bool>? isExempt)
    {
        const BindingFlags Own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic
            | BindingFlags.DeclaredOnly;
        for (Type? declaring = type;
            declaring is not null && declaring != typeof(object);
            declaring = declaring.BaseType)
        {
            foreach (FieldInfo field in declaring.GetFields(Own))
            {
                string fieldPath = $"{path}.{NameOf(field)}";
                if (!type.IsValueType && !field.IsInitOnly)
                    return $"{fieldPath} can be changed, and {TypeNames.Of(type)} is a class, which copies would "
                        + "share; make it readonly or use a struct.";
                if (FindFault(field.FieldType, fieldPath, visited, trusted, isExempt) is { } why)
                    return why;
            }
        }

        return null;
    }

    private static string? FindFaultInArguments(
        Type type, string path, HashSet<Type> visited, IReadOnlyCollection<Type> trusted, Func<Type, bool>? isExempt)
    {
        foreach (Type argument in type.GetGenericArguments())
        {
            if (FindFault(argument, $"{path}<{TypeNames.Of(argument)}>", visited, trusted, isExempt) is { } why)
                return why;
        }

        return null;
    }

    private static bool IsVouchedFor(Type type, IReadOnlyCollection<Type> trusted)
        => type.IsDefined(typeof(TrustedImmutableAttribute), inherit: false)
            || (type.IsGenericType && trusted.Contains(type.GetGenericTypeDefinition()));

    private static bool IsImmutableCollection(Type type)
        => type.Namespace is "System.Collections.Immutable" or "System.Collections.Frozen" && !type.IsInterface
            && !IsBuilder(type);

    private static bool IsBuilder(Type type) => type.Name == "Builder";

    // "<Samples>k__BackingField" is property Samples to its author.
    private static string NameOf(FieldInfo field)
    {
        int end = field.Name.IndexOf('>');
        return field.Name[0] == '<' && end > 1 ? field.Name.Substring(1, end - 1) : field.Name;
    }
}
