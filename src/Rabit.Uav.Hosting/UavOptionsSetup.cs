using System.Collections.Generic;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.Options;

namespace Rabit.Uav.Hosting;

/// <summary>
/// Reads the options from the configuration, and checks them when all who configure them have. Used by the thread that
/// starts the host.
/// </summary>
internal sealed class UavOptionsSetup(IConfigurationSection section)
    : IConfigureOptions<UavOptions>, IValidateOptions<UavOptions>
{
    private IReadOnlyList<string> _faults = [];

    public void Configure(UavOptions options) => _faults = UavConfiguration.Apply(section, options);

    public ValidateOptionsResult Validate(string? name, UavOptions options)
    {
        // What could not be read may be the cause of other faults: of one key both would be said, and "no link" of one
        // whose URL is wrong. So how options go together is judged when all of them are known.
        string[] faults = _faults.Concat(
            UavConfiguration.FindFaults(section, options).Where(f => _faults.Count == 0 || IsOfAnotherKey(f)))
            .ToArray();
        return faults.Length == 0 ? ValidateOptionsResult.Success : ValidateOptionsResult.Fail(faults);
    }

    private bool IsOfAnotherKey(string fault)
        => KeyOf(fault) is var key && key != section.Path + ":" && _faults.All(f => KeyOf(f) != key);

    private static string KeyOf(string fault) => fault.Split(' ')[0];
}
