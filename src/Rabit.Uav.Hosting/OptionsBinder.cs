using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Microsoft.Extensions.Configuration;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Hosting;

/// <summary>
/// Sets properties by the names in a section of a configuration, down to the options inside options. Unlike the binder
/// of .NET it goes through all that is wrong, and names what is not known.
/// </summary>
internal static class OptionsBinder
{
    // Set for the whole, in UavOptions: one setting has one name.
    private static readonly (Type Options, string Name)[] OfTheWhole =
    [
        (typeof(AutopilotOptions), nameof(AutopilotOptions.SystemId)),
        (typeof(AutopilotOptions), nameof(AutopilotOptions.ComponentId)),
        (typeof(AutopilotOptions), nameof(AutopilotOptions.MayCommand)),
        (typeof(AutopilotOptions), nameof(AutopilotOptions.RequestsRates)),
        (typeof(MissionControlOptions), nameof(MissionControlOptions.Mission)),
        (typeof(MissionControlOptions), nameof(MissionControlOptions.Terrain)),
        (typeof(MissionControlOptions), nameof(MissionControlOptions.RequiresPreflight)),
        (typeof(ImageProcessingOptions), nameof(ImageProcessingOptions.Terrain)),
        (typeof(CommunicationsOptions), nameof(CommunicationsOptions.Links)),
        (typeof(CommunicationsOptions), nameof(CommunicationsOptions.Signing)),
    ];

    /// <param name="section">Of the options.</param>
    /// <param name="options">Takes what the section says.</param>
    /// <param name="others">Keys that are read elsewhere.</param>
    /// <param name="faults">Takes a line for each setting that is wrong.</param>
    public static void Apply(
        IConfigurationSection section, object options, IReadOnlyList<string> others, List<string> faults)
    {
        if (!string.IsNullOrEmpty(section.Value))
            faults.Add($"{section.Path} is '{section.Value}'; it must have settings in it");
        Dictionary<string, PropertyInfo> properties = PropertiesOf(options.GetType());
        foreach (IConfigurationSection setting in section.GetChildren())
        {
            if (properties.TryGetValue(setting.Key, out PropertyInfo? property))
                Set(setting, options, property, faults);
            else if (!others.Contains(setting.Key, StringComparer.OrdinalIgnoreCase))
                faults.Add($"{setting.Path} is not known; there are: "
                    + string.Join(", ", properties.Keys.Concat(others).OrderBy(k => k, StringComparer.Ordinal)));
        }
    }

    public static bool Has(Type options, string name) => PropertiesOf(options).ContainsKey(name);

    /// <summary>The text of a setting; null where it is not given, or is none.</summary>
    public static string? TextOf(IConfigurationSection setting, List<string> faults)
    {
        if (setting.GetChildren().Any())
            faults.Add($"{setting.Path} has settings in it; it must be one value");
        else if (setting.Value is { Length: 0 })
            faults.Add($"{setting.Path} is empty");
        else
            return setting.Value;
        return null;
    }

    /// <summary>Whether an exception says that a setting or a file is wrong.</summary>
    public static bool IsBadInput(Exception e)
        => e is FormatException or ArgumentException or IOException or UnauthorizedAccessException
            or NotSupportedException or MissionPlanException or MissionProgressException;

    /// <summary>What an exception says, without the name of a parameter that .NET puts behind it.</summary>
    public static string SentenceOf(Exception e)
    {
        if (e is not ArgumentException { ParamName: not null })
            return e.Message;
        int end = e.Message.IndexOf(" (Parameter ", StringComparison.Ordinal);
        if (end < 0)
            end = e.Message.IndexOf('\n');   // under Mono
        return end < 0 ? e.Message : e.Message.Substring(0, end).TrimEnd();
    }

    private static Dictionary<string, PropertyInfo> PropertiesOf(Type type)
        => type.GetProperties(BindingFlags.Public | BindingFlags.Instance)
            .Where(p => p.GetSetMethod() is not null && !OfTheWhole.Contains((type, p.Name)) && IsKnown(p.PropertyType))
            .ToDictionary(p => p.Name, StringComparer.OrdinalIgnoreCase);

    private static bool IsKnown(Type type)
        => SettingText.Knows(Nullable.GetUnderlyingType(type) ?? type) || ItemOf(type) is not null || IsOptions(type);

    private static Type? ItemOf(Type type)
        => type.IsGenericType && type.GetGenericTypeDefinition() == typeof(IReadOnlyList<>)
            && SettingText.Knows(type.GetGenericArguments()[0])
            ? type.GetGenericArguments()[0]
            : null;

    private static bool IsOptions(Type type)
        => (type.Name.EndsWith("Options", StringComparison.Ordinal) || type == typeof(ErrorBudget))
            && type.GetConstructor(Type.EmptyTypes) is not null;

    private static void Set(
        IConfigurationSection setting, object options, PropertyInfo property, List<string> faults)
    {
        if (IsOptions(property.PropertyType))
        {
            object value = property.GetValue(options) ?? Activator.CreateInstance(property.PropertyType)!;
            Apply(setting, value, [], faults);
            property.SetValue(options, value);
        }
        else if (ItemOf(property.PropertyType) is { } item)
        {
            IConfigurationSection[] given = setting.GetChildren().ToArray();
            if (!string.IsNullOrEmpty(setting.Value))
                faults.Add($"{setting.Path} is '{setting.Value}'; it must be a list, as {setting.Path}:0");
            object?[] values = Array.ConvertAll(given, s => Read(s, item, faults));
            var list = Array.CreateInstance(item, values.Length);
            for (int i = 0; i < values.Length && Array.TrueForAll(values, v => v is not null); i++)
                list.SetValue(values[i], i);
            if (Array.TrueForAll(values, v => v is not null))
                property.SetValue(options, list);
        }
        else if (Read(setting, Nullable.GetUnderlyingType(property.PropertyType) ?? property.PropertyType, faults)
            is { } value)
        {
            property.SetValue(options, value);
        }
    }

    private static object? Read(IConfigurationSection setting, Type type, List<string> faults)
    {
        if (TextOf(setting, faults) is not { } text)
            return null;
        try
        {
            return SettingText.Parse(type, text);
        }
        catch (MissionPlanException e)
        {
            faults.Add($"{setting.Path} is '{text}': {e.Sentence}");
        }
        catch (Exception e) when (IsBadInput(e))
        {
            faults.Add($"{setting.Path} is '{text}'; {SentenceOf(e)}");
        }

        return null;
    }
}
