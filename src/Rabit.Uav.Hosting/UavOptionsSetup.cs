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
        // A fault of reading may be the cause of others: of one key both would be said.
        string[] faults = _faults.Concat(
            UavConfiguration.FindFaults(section, options).Where(f => !_faults.Any(r => IsOfSameKey(r, f)))).ToArray();
        return faults.Length == 0 ? ValidateOptionsResult.Success : ValidateOptionsResult.Fail(faults);
    }

    private static bool IsOfSameKey(string one, string other) => KeyOf(one) == KeyOf(other);

    private static string KeyOf(string fault) => fault.Split(' ')[0];
}
