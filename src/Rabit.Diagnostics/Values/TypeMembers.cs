using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.Json;

namespace Rabit.Diagnostics.Values;

/// <summary>The public fields and properties of types, looked up once. One thread only.</summary>
internal sealed class TypeMembers
{
    private const BindingFlags Public = BindingFlags.Instance | BindingFlags.Public;

    private readonly Dictionary<Type, ReadableMember[]> _known = [];

    public IReadOnlyList<ReadableMember> Of(Type type)
    {
        if (!_known.TryGetValue(type, out ReadableMember[]? members))
            _known.Add(type, members = Find(type));
        return members;
    }

    private static ReadableMember[] Find(Type type)
    {
        IEnumerable<ReadableMember> fields = type.GetFields(Public).Where(f => IsReadable(f.FieldType))
            .Select(f => new ReadableMember(NameOf(f), f.GetValue));
        IEnumerable<ReadableMember> properties = type.GetProperties(Public)
            .Where(p => p.GetMethod is { IsPublic: true } && p.GetIndexParameters().Length == 0
                && IsReadable(p.PropertyType) && !IsDerivedFromItself(p, type))
            .Select(p => new ReadableMember(NameOf(p), p.GetValue));

        // A member that hides that of a base class comes first.
        return fields.Concat(properties).DistinctBy(m => m.JsonName, StringComparer.Ordinal).ToArray();
    }

    private static bool IsReadable(Type type) => !type.IsByRefLike && !type.IsPointer && !type.IsFunctionPointer
        && !(type.IsByRef && !IsReadable(type.GetElementType()!));

    // A struct cannot hold one of its own type: a property of that type is computed, and has such a property again.
    private static bool IsDerivedFromItself(PropertyInfo property, Type type)
        => type.IsValueType && property.PropertyType == type;

    private static string NameOf(MemberInfo member) => JsonNamingPolicy.CamelCase.ConvertName(member.Name);
}
