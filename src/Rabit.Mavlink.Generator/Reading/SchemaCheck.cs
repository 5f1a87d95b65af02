using System;
using System.Linq;
using System.Xml;
using System.Xml.Linq;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// Reports elements and attributes that the schema does not have, which the reader would ignore. A name that is nearly
/// a known one, or an element in the wrong place, is certainly a mistake. Another may come from a newer schema or a
/// tool of the user's, so it is a warning. Names in an XML namespace of their own belong to another tool and are left
/// alone.
/// </summary>
internal static class SchemaCheck
{
    public static void Check(DefinitionElement file) => Check(file, file.Element);

    private static void Check(DefinitionElement file, XElement element)
    {
        if (DefinitionSchema.Find(element.Name.LocalName) is not { } rule)
            return;
        foreach (XAttribute attribute in element.Attributes())
            CheckAttribute(file, attribute, rule);
        // Prose may hold any markup.
        if (rule.Name is "description")
            return;
        foreach (XElement child in element.Elements().Where(child => child.Name.NamespaceName.Length == 0))
        {
            if (rule.Children.Contains(child.Name.LocalName, StringComparer.Ordinal))
                Check(file, child);
            else
                ReportElement(file.Child(child), rule);
        }
    }

    private static void ReportElement(DefinitionElement element, DefinitionElementRule parent)
    {
        string name = element.Element.Name.LocalName;
        string[] places = DefinitionSchema.ParentsOf(name).ToArray();
        if (places.Length != 0)
        {
            element.Fault(
                DialectFaultKind.MisspeltName,
                $"Element '{name}' cannot stand in '{parent.Name}'; it belongs in {Either(places)}.");
        }
        else if (Spelling.Nearest(name, parent.Children) is { } meant)
        {
            element.Fault(
                DialectFaultKind.MisspeltName,
                $"There is no element '{name}' in '{parent.Name}'; '{meant}' is probably meant.");
        }
        else
        {
            element.Fault(
                DialectFaultKind.UnknownName,
                $"There is no element '{name}' in '{parent.Name}'; it is ignored, with all that it contains.");
        }
    }

    private static void CheckAttribute(DefinitionElement file, XAttribute attribute, DefinitionElementRule rule)
    {
        string name = attribute.Name.LocalName;
        bool isOfAnotherTool = attribute.IsNamespaceDeclaration || attribute.Name.NamespaceName.Length != 0;
        if (isOfAnotherTool || rule.Attributes.Contains(name, StringComparer.Ordinal))
            return;
        string[] owners = DefinitionSchema.OwnersOf(name).ToArray();
        if (owners.Length == 0 && Spelling.Nearest(name, rule.Attributes) is { } meant)
        {
            file.Fault(
                DialectFaultKind.MisspeltName, attribute,
                $"There is no attribute '{name}' of '{rule.Name}'; '{meant}' is probably meant.");
            return;
        }

        string hint = owners.Length == 0 ? "" : $" (it is one of {Either(owners)})";
        file.Fault(
            DialectFaultKind.UnknownName, attribute,
            $"There is no attribute '{name}' of '{rule.Name}'{hint}; it is ignored.");
    }

    private static string Either(string[] names)
    {
        string quoted = string.Join(", ", names.Select(name => $"'{name}'"));
        int last = quoted.LastIndexOf(", ", StringComparison.Ordinal);
        return last < 0 ? quoted : quoted.Substring(0, last) + " or " + quoted.Substring(last + 2);
    }
}
