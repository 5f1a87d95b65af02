using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text;
using Xunit;

namespace Rabit.Tests.Shared;

/// <summary>
/// The public surface of an assembly as text, one line for each type and member, so that a change of it is seen in
/// review. The text is the same for every target framework.
/// </summary>
internal static class PublicApiText
{
    /// <summary>Set to 1, the tests write the file instead of comparing with it.</summary>
    private const string UpdateVariable = "RABIT_UPDATE_API";

    private const BindingFlags Declared
        = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static
            | BindingFlags.DeclaredOnly;

    /// <summary>Compares an assembly with the file that holds its public surface.</summary>
    /// <param name="assembly">The assembly.</param>
    /// <param name="fileInRepository">The file, from the repository's root.</param>
    /// <param name="exceptNamespace">A namespace that is left out, because it is generated.</param>
    public static void AssertUnchanged(Assembly assembly, string fileInRepository, string? exceptNamespace = null)
    {
        string file = Path.Combine(Repository.Root, fileInRepository.Replace('/', Path.DirectorySeparatorChar));
        string[] actual = Describe(assembly, exceptNamespace).ToArray();
        if (string.Equals(Environment.GetEnvironmentVariable(UpdateVariable), "1", StringComparison.Ordinal))
            File.WriteAllText(file, string.Join("\n", actual) + "\n");

        string[] expected = File.Exists(file) ? File.ReadAllLines(file) : [];
        string[] added = actual.Except(expected, StringComparer.Ordinal).Select(line => "+ " + line).ToArray();
        string[] removed = expected.Except(actual, StringComparer.Ordinal).Select(line => "- " + line).ToArray();
        if (added.Length + removed.Length > 0)
        {
            Assert.Fail(
                $"The public surface of {assembly.GetName().Name} is not that of {fileInRepository}.\n"
                + string.Join("\n", removed.Concat(added))
                + $"\nIf that is meant, run the tests once with {UpdateVariable}=1 and review the file.");
        }
    }

    public static IEnumerable<string> Describe(Assembly assembly, string? exceptNamespace = null)
        => assembly.GetTypes().Where(t => IsVisible(t) && (exceptNamespace is null || t.Namespace != exceptNamespace))
            .OrderBy(Name, StringComparer.Ordinal).SelectMany(DescribeType);

    private static IEnumerable<string> DescribeType(Type type)
    {
        yield return DescribeHead(type);
        IEnumerable<string> members = type.IsEnum
            ? type.GetFields(BindingFlags.Public | BindingFlags.Static)
                .Select(f =>
                    $"{f.Name} = {Convert.ToInt64(f.GetRawConstantValue(), CultureInfo.InvariantCulture).ToString(CultureInfo.InvariantCulture)}")
            : IsDelegate(type)
                ? [Describe(type.GetMethod("Invoke")!)]
                : type.GetMembers(Declared).Select(DescribeMember).OfType<string>();
        foreach (string member in members.OrderBy(m => m, StringComparer.Ordinal))
            yield return $"{Name(type)}: {member}";
    }

    private static string DescribeHead(Type type)
    {
        string kind = type.IsEnum ? "enum"
            : IsDelegate(type) ? "delegate"
            : type.IsInterface ? "interface"
            : type.IsValueType ? (HasAttribute(type, "IsReadOnlyAttribute") ? "readonly struct" : "struct")
            : type.IsAbstract && type.IsSealed ? "static class"
            : type.IsAbstract ? "abstract class"
            : type.IsSealed ? "sealed class"
            : "class";
        var bases = new List<string>();
        if (type.IsClass && type.BaseType != typeof(object) && !IsDelegate(type))
            bases.Add(Name(type.BaseType!));
        if (!type.IsEnum && !IsDelegate(type))
        {
            // What a base type or another interface brings along depends on the framework.
            Type[] all = type.GetInterfaces().Where(IsVisible).ToArray();
            bases.AddRange(all
                .Where(i => type.BaseType is null || !type.BaseType.GetInterfaces().Contains(i))
                .Select(Name)
                .OrderBy(n => n, StringComparer.Ordinal));
        }

        return $"{kind} {Name(type)}" + (bases.Count == 0 ? string.Empty : " : " + string.Join(", ", bases))
            + Constraints(type.GetGenericArguments());
    }

    private static string? DescribeMember(MemberInfo member) => member switch
    {
        FieldInfo field when IsVisible(field) => Describe(field),
        ConstructorInfo constructor when IsVisible(constructor) =>
            $"{Access(constructor)}new({Parameters(constructor)})",
        PropertyInfo property when property.GetAccessors(nonPublic: true).Any(IsVisible) => Describe(property),
        EventInfo @event when IsVisible(@event.AddMethod!) =>
            $"{Access(@event.AddMethod!)}event {Name(@event.EventHandlerType!)} {@event.Name}",
        MethodInfo method when IsVisible(method)
            && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal)) =>
            Describe(method),
        _ => null,
    };

    private static string Describe(FieldInfo field)
    {
        string kind = field.IsLiteral
            ? "const "
            : (field.IsStatic ? "static " : string.Empty) + (field.IsInitOnly ? "readonly " : string.Empty);
        string value = field.IsLiteral ? " = " + Literal(field.GetRawConstantValue()) : string.Empty;
        return $"{(field.IsPublic ? string.Empty : "protected ")}{kind}{Name(field.FieldType)} {field.Name}{value}";
    }

    private static string Describe(PropertyInfo property)
    {
        MethodInfo[] accessors = property.GetAccessors(nonPublic: true).Where(IsVisible)
            .OrderBy(Word, StringComparer.Ordinal).ToArray();
        MethodInfo widest = accessors.FirstOrDefault(a => a.IsPublic) ?? accessors[0];
        string parameters = property.GetIndexParameters().Length == 0
            ? property.Name
            : $"this[{Parameters(property.GetIndexParameters())}]";
        IEnumerable<string> words = accessors.Select(
            a => (a.IsPublic == widest.IsPublic ? string.Empty : Access(a)) + Word(a) + ";");
        return $"{Access(widest)}{Returned(property.GetMethod?.ReturnParameter, property.PropertyType)} {parameters} "
            + $"{{ {string.Join(" ", words)} }}";

        static string Word(MethodInfo accessor)
        {
            if (accessor.ReturnType != typeof(void))
                return "get";
            bool isInit = accessor.ReturnParameter.GetRequiredCustomModifiers().Any(m => m.Name == "IsExternalInit");
            return isInit ? "init" : "set";
        }
    }

    private static string Describe(MethodInfo method)
    {
        Type[] generic = method.GetGenericArguments();
        string name = method.Name
            + (generic.Length == 0 ? string.Empty : "<" + string.Join(", ", generic.Select(Name)) + ">");
        return $"{Access(method)}{Returned(method.ReturnParameter, method.ReturnType)} "
            + $"{name}({Parameters(method)}){Constraints(generic)}";
    }

    private static string Access(MethodBase method)
    {
        string access = method.IsPublic ? string.Empty : "protected ";
        if (method.IsStatic)
            return access + "static ";
        if (method is not MethodInfo info || method.DeclaringType!.IsInterface || !method.IsVirtual
            || (method.IsFinal && info.GetBaseDefinition() == info))
            return access;
        string kind = info.GetBaseDefinition() != info ? "override "
            : method.IsAbstract ? "abstract "
            : method.IsFinal ? string.Empty
            : "virtual ";
        return access + kind;
    }

    private static string Returned(ParameterInfo? parameter, Type type)
    {
        if (!type.IsByRef)
            return Name(type);
        bool isReadOnly = parameter is not null && HasAttribute(parameter, "IsReadOnlyAttribute");
        return (isReadOnly ? "ref readonly " : "ref ") + Name(type.GetElementType()!);
    }

    private static string Parameters(MethodBase method) => Parameters(method.GetParameters());

    private static string Parameters(ParameterInfo[] parameters) => string.Join(", ", parameters.Select(Describe));

    private static string Describe(ParameterInfo parameter)
    {
        Type type = parameter.ParameterType;
        string kind = parameter.IsDefined(typeof(ParamArrayAttribute), inherit: false) ? "params "
            : !type.IsByRef ? string.Empty
            : parameter.IsOut ? "out "
            : parameter.IsIn ? "in "
            : "ref ";
        string value = parameter.HasDefaultValue ? " = " + Default(parameter) : string.Empty;
        return $"{kind}{Name(type.IsByRef ? type.GetElementType()! : type)} {parameter.Name}{value}";
    }

    private static string Default(ParameterInfo parameter)
    {
        object? value = parameter.RawDefaultValue;
        return value is null && parameter.ParameterType.IsValueType ? "default" : Literal(value);
    }

    private static string Literal(object? value) => value switch
    {
        null => "null",
        string text => "\"" + text + "\"",
        bool yes => yes ? "true" : "false",
        // the shortest form differs between runtimes
        double number => number.ToString("G17", CultureInfo.InvariantCulture),
        _ => Convert.ToString(value, CultureInfo.InvariantCulture)!,
    };

    private static string Constraints(Type[] arguments)
    {
        var text = new StringBuilder();
        foreach (Type argument in arguments.Where(a => a.IsGenericParameter))
        {
            GenericParameterAttributes attributes = argument.GenericParameterAttributes;
            bool isStruct = (attributes & GenericParameterAttributes.NotNullableValueTypeConstraint) != 0;
            var words = new List<string>();
            if (isStruct)
                words.Add("struct");
            if ((attributes & GenericParameterAttributes.ReferenceTypeConstraint) != 0)
                words.Add("class");
            words.AddRange(argument.GetGenericParameterConstraints().Where(c => c != typeof(ValueType)).Select(Name));
            if (!isStruct && (attributes & GenericParameterAttributes.DefaultConstructorConstraint) != 0)
                words.Add("new()");
            if (words.Count > 0)
                text.Append(" where ").Append(argument.Name).Append(" : ").Append(string.Join(", ", words));
        }

        return text.ToString();
    }

    private static string Name(Type type)
    {
        if (type.IsArray)
            return Name(type.GetElementType()!) + "[" + new string(',', type.GetArrayRank() - 1) + "]";
        if (type.IsGenericParameter)
            return type.Name;
        if (type.IsPointer)
            return Name(type.GetElementType()!) + "*";
        string name = type.IsNested
            ? Name(type.DeclaringType!) + "." + type.Name
            : Keyword(type) ?? type.FullName ?? type.Namespace + "." + type.Name;
        int tick = name.IndexOf('`');
        if (tick < 0)
            return name;
        return name.Remove(tick) + "<" + string.Join(", ", type.GetGenericArguments().Select(Name)) + ">";
    }

    private static string? Keyword(Type type)
        => type == typeof(void) ? "void"
        : type == typeof(object) ? "object"
        : type == typeof(string) ? "string"
        : type == typeof(bool) ? "bool"
        : type == typeof(byte) ? "byte"
        : type == typeof(sbyte) ? "sbyte"
        : type == typeof(short) ? "short"
        : type == typeof(ushort) ? "ushort"
        : type == typeof(int) ? "int"
        : type == typeof(uint) ? "uint"
        : type == typeof(long) ? "long"
        : type == typeof(ulong) ? "ulong"
        : type == typeof(float) ? "float"
        : type == typeof(double) ? "double"
        : type == typeof(char) ? "char"
        : null;

    private static bool IsVisible(Type type)
        => type.IsVisible
            || ((type.IsNestedFamily || type.IsNestedFamORAssem)
                && type.DeclaringType is { IsVisible: true, IsSealed: false });

    private static bool IsVisible(FieldInfo field)
        => field.IsPublic || ((field.IsFamily || field.IsFamilyOrAssembly) && !field.DeclaringType!.IsSealed);

    private static bool IsVisible(MethodBase method)
        => method.IsPublic || ((method.IsFamily || method.IsFamilyOrAssembly) && !method.DeclaringType!.IsSealed);

    private static bool IsDelegate(Type type) => typeof(MulticastDelegate).IsAssignableFrom(type.BaseType);

    // By name: down-level the compiler puts an attribute of its own into each assembly.
    private static bool HasAttribute(ICustomAttributeProvider member, string name)
        => member switch
        {
            Type type => type.GetCustomAttributesData().Any(a => a.AttributeType.Name == name),
            ParameterInfo parameter => parameter.GetCustomAttributesData().Any(a => a.AttributeType.Name == name),
            _ => false,
        };
}
