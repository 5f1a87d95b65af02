using System;
using System.IO;
using System.Security.Cryptography;
using System.Text;

namespace Rabit.Uav.Web.Serving;

/// <summary>
/// The page: one file with its style and its program, and the policy by which a browser runs exactly that program and
/// loads nothing from elsewhere. Immutable.
/// </summary>
internal sealed class PageFile
{
    private PageFile(byte[] html, string policy) => (Html, Policy) = (html, policy);

    public byte[] Html { get; }

    /// <summary>For the header Content-Security-Policy.</summary>
    public string Policy { get; }

    public static PageFile Load()
    {
        string style = Resource("page.css");
        string program = "\"use strict\";\n" + Resource("map.js") + Resource("page.js");
        string html = Resource("page.html").Replace("/*style*/", style, StringComparison.Ordinal)
            .Replace("/*program*/", program, StringComparison.Ordinal);
        string policy = $"default-src 'none'; script-src '{HashOf(program)}'; style-src '{HashOf(style)}'; "
            + "img-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
        return new PageFile(Encoding.UTF8.GetBytes(html), policy);
    }

    private static string HashOf(string text)
        => "sha256-" + Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(text)));

    private static string Resource(string name)
    {
        using Stream stream = typeof(PageFile).Assembly.GetManifestResourceStream("Rabit.Uav.Web.Page." + name)!;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd().Replace("\r", string.Empty, StringComparison.Ordinal);
    }
}
