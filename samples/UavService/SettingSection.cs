using System;
using System.Linq;
using Microsoft.Extensions.Configuration;

namespace UavService;

/// <summary>Reads a section of the configuration that is the service's own.</summary>
internal static class SettingSection
{
    /// <exception cref="SettingException">
    /// A setting is not known, or its value is none of its kind; all that are not known are named.
    /// </exception>
    public static T Read<T>(IConfiguration configuration, string name)
        where T : class, new()
    {
        IConfigurationSection section = configuration.GetSection(name);
        string[] known = typeof(T).GetProperties().Select(p => p.Name).ToArray();
        string[] unknown = section.GetChildren()
            .Where(s => !known.Contains(s.Key, StringComparer.OrdinalIgnoreCase))
            .Select(s => $"{s.Path} is not known; there are: {string.Join(", ", known)}").ToArray();
        if (unknown.Length > 0)
            throw new SettingException(unknown);
        try
        {
            return section.Get<T>() ?? new T();
        }
        catch (InvalidOperationException e)
        {
            // It names the key and the value.
            throw new SettingException([e.Message]);
        }
    }
}
